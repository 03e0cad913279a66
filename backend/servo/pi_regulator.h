// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace teleta::servo {

/// Proportional-integral law of each component with anti-windup.
///   u = K_P e + i,   i += K_I (e - e_P) dt, kept within +-integralLimit
/// e_P is what K_P alone would have left by now of the error at the start: e_P' = -|K_P| e_P for components
/// whose error follows the twist one to one, and 0 for the others. The integral therefore learns
/// disturbances, not the transient: from rest the error falls as e(0) exp(-K_P t) without overshoot
/// (integrating e alone would overshoot by the area accumulated before), while the effect of a slope is
/// removed as by e alone. The start is the first known error, the first one after a limit acted, or a change
/// of the desired value. The integral is stored as its share of u, so that new gains cause no step.
/// Anti-windup: when a limit cut the output of a component, its last increment is undone if it pushed
/// further. Thread: one. Source: eq. (13); e_P: the reference model of a control law with two degrees of
/// freedom.
class PiRegulator {
public:
    struct Rows {
        /// Components in use. The integral of the others, and of those without K_I, is cleared.
        std::array<bool, 6> takesPart{};
        /// Components whose error is known. The others output 0 and keep their integral.
        std::array<bool, 6> known{};
        /// Components whose error changes as fast as the twist moves the sensor.
        std::array<bool, 6> oneToOne{};
    };

    [[nodiscard]] Twist step(const Vector6& error, const Rows& rows, double dt_s, const ServoGains& gains) {
        Twist u = Twist::Zero();
        m_increment.setZero();
        for (int i = 0; i < 6; ++i) {
            const auto component = static_cast<std::size_t>(i);
            if (!rows.takesPart[component] || gains.integral[i] == 0.0)
                m_integral[i] = 0.0;
            if (!rows.takesPart[component] || !rows.known[component]) {
                m_started[component] = false;
                continue;
            }
            const double gain = std::abs(gains.proportional[i]);
            if (!std::exchange(m_started[component], true))
                m_expected[i] = error[i];
            if (!rows.oneToOne[component] || gain == 0.0)
                m_expected[i] = 0.0;
            const double limit = gains.integralLimit[i];
            const double next = std::clamp(
                m_integral[i] + gains.integral[i] * (error[i] - m_expected[i]) * dt_s, -limit, limit);
            m_expected[i] *= std::max(0.0, 1.0 - gain * dt_s);
            m_increment[i] = next - m_integral[i];
            m_integral[i] = next;
            u[i] = gains.proportional[i] * error[i] + next;
        }
        return u;
    }

    /// Tells the regulator that the desired value, and with it the error, has changed by this.
    void expect(const Vector6& change) { m_expected += change; }

    /// Anti-windup. cut: wanted minus achieved twist of the last step.
    void giveBack(const Twist& cut) {
        for (int i = 0; i < 6; ++i) {
            if (cut[i] * m_increment[i] > 0.0)
                m_integral[i] -= m_increment[i];
            if (cut[i] != 0.0)
                m_started[static_cast<std::size_t>(i)] = false;
        }
    }

    /// Share of the integral in the output; m/s, rad/s.
    [[nodiscard]] const Vector6& integral() const { return m_integral; }
    void reset() {
        m_integral.setZero();
        m_increment.setZero();
        m_expected.setZero();
        m_started.fill(false);
    }

private:
    Vector6 m_integral = Vector6::Zero();
    Vector6 m_increment = Vector6::Zero();
    Vector6 m_expected = Vector6::Zero(); ///< e_P
    std::array<bool, 6> m_started{};
};

} // namespace teleta::servo
