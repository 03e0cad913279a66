// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/stamps.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace teleta::ros {

/// Time of what messages carry, from the first one, in s: that of their stamps, and where there is none, or
/// it does not rise, our clock goes on. Thread: one.
class SourceClock {
public:
    /// stamp: null when such messages have none. read_ns: steady time.
    double at(const Time* stamp, std::int64_t read_ns) {
        const std::int64_t before_ns = std::exchange(m_read_ns, read_ns).value_or(read_ns);
        double step_s = static_cast<double>(read_ns - before_ns) * 1e-9;
        if (stamp != nullptr) {
            m_check.see(*stamp);
            const double told_s = seconds(*stamp);
            if (m_stamp_s && told_s > *m_stamp_s)
                step_s = told_s - *m_stamp_s;
            m_stamp_s = told_s == 0.0 ? std::nullopt : std::optional(told_s);
        }
        m_time_s += step_s;
        return m_time_s;
    }

    /// Of the newest message; nothing before the first one.
    [[nodiscard]] std::optional<std::int64_t> lastRead_ns() const { return m_read_ns; }
    /// Stamps that are zero, the same as the one before, or before it.
    [[nodiscard]] std::uint64_t oddStamps() const {
        return m_check.zero() + m_check.equal() + m_check.backward();
    }

private:
    StampCheck m_check;
    std::optional<double> m_stamp_s;
    std::optional<std::int64_t> m_read_ns;
    double m_time_s = 0.0;
};

} // namespace teleta::ros
