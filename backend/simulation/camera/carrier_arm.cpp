// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/carrier_arm.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

void CarrierArm::step(const TubeVelocity& asked, double dt_s) {
    const auto toward = [](double now, double target, double most, double change) {
        const double limited = std::isfinite(target) ? std::clamp(target, -most, most) : 0.0;
        return now + std::clamp(limited - now, -change, change);
    };
    m_velocity.turn_radPerS = toward(m_velocity.turn_radPerS, asked.turn_radPerS, m_limits.turn_radPerS,
                                     m_limits.turnAcceleration_radPerS2 * dt_s);
    m_velocity.along_mPerS = toward(m_velocity.along_mPerS, asked.along_mPerS, m_limits.speed_mPerS,
                                    m_limits.acceleration_mPerS2 * dt_s);
    Eigen::Vector2d aside = asked.aside_mPerS.allFinite() ? asked.aside_mPerS : Eigen::Vector2d::Zero();
    if (aside.norm() > m_limits.speed_mPerS)
        aside *= m_limits.speed_mPerS / aside.norm();
    Eigen::Vector2d change = aside - m_velocity.aside_mPerS;
    if (const double most = m_limits.acceleration_mPerS2 * dt_s; change.norm() > most)
        change *= most / change.norm();
    m_velocity.aside_mPerS += change;
    m_pose.turn_rad += m_velocity.turn_radPerS * dt_s;
    m_pose.along_m += m_velocity.along_mPerS * dt_s;
    m_pose.aside_m += m_velocity.aside_mPerS * dt_s;
}

} // namespace teleta::simulation
