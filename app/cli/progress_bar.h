// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::cli {

/// A line on standard error that shows how far a file was read: bar, percent, rate. Nothing is shown when
/// standard error is no terminal, or when results are printed to a terminal. The line is erased with the
/// object.
class ProgressBar {
public:
    /// totalBytes 0: unknown, only amount and rate are shown.
    explicit ProgressBar(std::uint64_t totalBytes, bool resultsOnTerminal);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Cheap; draws a few times a second.
    void update(std::uint64_t doneBytes);

private:
    std::uint64_t m_totalBytes;
    bool m_shown;
    bool m_drawn = false;
    std::int64_t m_start_ns;
    std::int64_t m_next_ns;
};

} // namespace teleta::cli
