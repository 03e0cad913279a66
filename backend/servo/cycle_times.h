// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace teleta::servo {

/// What the control cycle of a simulated servo spends its time on.
enum class CyclePart {
    contact,    ///< springs of the array on the object
    kinematics, ///< posture and Jacobian of the arm
    features,   ///< image processing
    control,    ///< the servo's step
    dynamics,   ///< what is left: the step of arm and contact, effects of the sensor
};

inline constexpr std::size_t kCycleParts = 5;
inline constexpr std::array<std::string_view, kCycleParts> kCyclePartNames{"contact", "kinematics",
                                                                           "features", "control", "dynamics"};

/// Computing time of the parts of a control cycle, in s, of the cycles that were timed. Only one in kEvery
/// is, since to read the clock takes longer than some of the parts; kEvery has no divisor in common with the
/// rates of a servo, so that each of its cycles has its turn.
struct CycleTimes {
    static constexpr std::uint64_t kEvery = 17;

    std::array<double, kCycleParts> part_s{};
    std::uint64_t cycles = 0; ///< that were timed

    [[nodiscard]] double& of(CyclePart part) { return part_s[static_cast<std::size_t>(part)]; }
    /// Takes the times of one cycle. Those that took longer than a whole cycle of 1 kHz were interrupted by
    /// another program and say nothing.
    void add(const CycleTimes& cycle) {
        if (cycle.sum_s() > 1e-3)
            return;
        for (std::size_t i = 0; i < kCycleParts; ++i)
            part_s[i] += cycle.part_s[i];
        ++cycles;
    }
    [[nodiscard]] double sum_s() const {
        double sum_s = 0.0;
        for (const double each_s : part_s)
            sum_s += each_s;
        return sum_s;
    }
};

/// Adds the time from its start to its end to a part; nothing without times.
class CycleTimer {
public:
    CycleTimer(CycleTimes* times, CyclePart part)
        : m_times(times)
        , m_part(part)
        , m_start_ns(times != nullptr ? core::steadyNow_ns() : 0) {}
    ~CycleTimer() {
        if (m_times != nullptr)
            m_times->of(m_part) += 1e-9 * static_cast<double>(core::steadyNow_ns() - m_start_ns);
    }
    CycleTimer(const CycleTimer&) = delete;
    CycleTimer& operator=(const CycleTimer&) = delete;

private:
    CycleTimes* m_times;
    CyclePart m_part;
    std::int64_t m_start_ns;
};

} // namespace teleta::servo
