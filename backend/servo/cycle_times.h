// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace teleta::servo {

/// The parts into which the computing time of a simulated control cycle is divided.
enum class CyclePart {
    contact,    ///< springs of the array on the object
    kinematics, ///< posture and Jacobian of the arm
    features,   ///< image processing
    control,    ///< the step of the servo controller
    dynamics,   ///< everything else: the step of arm and contact, effects of the sensor
};

inline constexpr std::size_t kCycleParts = 5;
inline constexpr std::array<std::string_view, kCycleParts> kCyclePartNames{"contact", "kinematics",
                                                                           "features", "control", "dynamics"};

/// Computing time of each part, summed over the timed control cycles, in s. Only one cycle in kEvery is
/// timed, because reading the clock takes longer than some of the parts. kEvery has no divisor in common with
/// the rates of a servo, so that all kinds of cycle are timed.
struct CycleTimes {
    static constexpr std::uint64_t kEvery = 17;

    std::array<double, kCycleParts> part_s{};
    std::uint64_t cycles = 0; ///< number of timed cycles

    [[nodiscard]] double& of(CyclePart part) { return part_s[static_cast<std::size_t>(part)]; }
    /// Adds the times of one cycle. Cycles that took longer than the whole period at 1 kHz were interrupted
    /// by another program and are ignored.
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

/// Adds the time between its construction and destruction to a part; does nothing when times is null.
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
