// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <algorithm>
#include <array>

namespace teleta::servo {

/// Proportional-integral law of each component with anti-windup.
///   u = K_P e + i,   i += K_I e dt, kept within +-integralLimit
/// The integral is kept as its share of u, so new gains change nothing at once. What did not become motion
/// because of a limit is given back: the last increment of a component whose output was cut is undone when it
/// pushed further. Thread: one. Source: eq. (13).
class PiRegulator {
public:
    /// takesPart: the integral of the other components, and of those without K_I, is forgotten. known: a
    /// component whose error is not known puts out 0 and keeps its integral.
    [[nodiscard]] Twist step(const Vector6& error, const std::array<bool, 6>& takesPart,
                             const std::array<bool, 6>& known, double dt_s, const ServoGains& gains) {
        Twist u = Twist::Zero();
        m_increment.setZero();
        for (int i = 0; i < 6; ++i) {
            const auto component = static_cast<std::size_t>(i);
            if (!takesPart[component] || gains.integral[i] == 0.0)
                m_integral[i] = 0.0;
            if (!takesPart[component] || !known[component])
                continue;
            const double limit = gains.integralLimit[i];
            const double next =
                std::clamp(m_integral[i] + gains.integral[i] * error[i] * dt_s, -limit, limit);
            m_increment[i] = next - m_integral[i];
            m_integral[i] = next;
            u[i] = gains.proportional[i] * error[i] + next;
        }
        return u;
    }

    /// cut: wanted minus achieved twist of the last step.
    void giveBack(const Twist& cut) {
        for (int i = 0; i < 6; ++i)
            if (cut[i] * m_increment[i] > 0.0)
                m_integral[i] -= m_increment[i];
    }

    /// The integral's share of the output. m/s, rad/s.
    [[nodiscard]] const Vector6& integral() const { return m_integral; }
    void reset() {
        m_integral.setZero();
        m_increment.setZero();
    }

private:
    Vector6 m_integral = Vector6::Zero();
    Vector6 m_increment = Vector6::Zero();
};

} // namespace teleta::servo
