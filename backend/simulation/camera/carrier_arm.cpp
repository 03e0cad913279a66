// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/carrier_arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

CommandedCarrier::CommandedCarrier(std::shared_ptr<CarrierLink> link, double rate_Hz)
    : m_link(std::move(link))
    , m_commandFrames(std::max(1, static_cast<int>(std::ceil(kCarrierCommand_s * rate_Hz)))) {
}

TubeVelocity CommandedCarrier::next(bool held) {
    const auto asked = m_link->asked.take();
    if (held) {
        m_commandAge = m_commandFrames;
    } else if (asked) {
        m_asked = *asked;
        m_commandAge = 0;
    } else if (m_commandAge < m_commandFrames) {
        ++m_commandAge;
    }
    return m_commandAge < m_commandFrames ? m_asked : TubeVelocity();
}

void CommandedCarrier::restart() {
    m_asked = {};
    (void)m_link->asked.take();
    m_commandAge = m_commandFrames;
    ++m_restarts;
}

void CommandedCarrier::tell(const TubePose& pose, bool held) {
    m_link->state.set(
        {.pose = pose, .held = held || m_commandAge >= m_commandFrames, .restarts = m_restarts});
}

} // namespace teleta::simulation
