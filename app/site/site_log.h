// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/site/site_control.h"

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

namespace teleta::site_program {

/// What happens at the site, a line each: as JSON on standard output, or for people on standard error.
///   {"time": "2026-11-27T18:30:00.123Z", "severity": "note", "source": .., "code": .., "message": ..}
/// Who writes never waits for the reader: flush() prints. Of more than kMostLines that wait the oldest are
/// lost and counted. Thread: write() from any, flush() from one.
class SiteLog {
public:
    static constexpr std::size_t kMostLines = 1000;

    explicit SiteLog(bool json)
        : m_json(json) {}

    void write(const site_link::SiteNews& news);
    void flush();

private:
    bool m_json;
    std::mutex m_mutex;
    std::deque<std::string> m_lines; ///< guarded by m_mutex, as the next one
    std::uint64_t m_lost = 0;
};

} // namespace teleta::site_program
