// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

namespace teleta::cost {

/// Processor time of the calling thread. Thread: any.
[[nodiscard]] inline std::int64_t threadTime_ns() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

/// One timed piece of a rung's work and how far its answers are from the truth. Only what runs inside timed()
/// counts as time; inputs are made before it, answers are compared after it. Thread: one.
class Trial {
public:
    /// index: number of the trial, from 0; the same index gives every rung of a ladder the same inputs.
    explicit Trial(std::size_t index)
        : m_index(index) {}

    [[nodiscard]] std::size_t index() const { return m_index; }

    /// Runs work once. calls: how many calls of the rung it makes, > 0; short ones are put together, so that
    /// reading the clock counts for nothing.
    template <typename Work>
    void timed(std::size_t calls, Work&& work) {
        const std::int64_t ownStart_ns = threadTime_ns();
        const std::int64_t start_ns = core::steadyNow_ns();
        work();
        const std::int64_t end_ns = core::steadyNow_ns();
        const std::int64_t ownEnd_ns = threadTime_ns();
        const double wall_s = core::elapsed_s(start_ns, end_ns);
        m_time_s = wall_s / static_cast<double>(calls);
        m_takenAway =
            wall_s > 0.0 ? std::clamp(1.0 - core::elapsed_s(ownStart_ns, ownEnd_ns) / wall_s, 0.0, 1.0) : 0.0;
    }

    /// Adds how far an answer is from the truth; >= 0. NaN: it has none, and neither has the rung.
    void error(double error) { m_errors.push_back(error); }

    [[nodiscard]] double time_s() const { return m_time_s; }       ///< of one call
    [[nodiscard]] double takenAway() const { return m_takenAway; } ///< share of it that others computed
    [[nodiscard]] const std::vector<double>& errors() const { return m_errors; }

private:
    std::size_t m_index;
    double m_time_s = 0.0;
    double m_takenAway = 0.0;
    std::vector<double> m_errors;
};

} // namespace teleta::cost
