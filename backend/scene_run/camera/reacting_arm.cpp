// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/reacting_arm.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace teleta::scene_run {

double brakingSpeed_mPerS(double left_m, const scene::CarrierLimits& limits, double period_s) {
    const double brake_mPerS2 = 0.8 * limits.acceleration_mPerS2;
    return std::min(limits.speed_mPerS, std::sqrt(std::pow(brake_mPerS2 * period_s, 2) +
                                                  2.0 * brake_mPerS2 * std::max(left_m, 0.0)) -
                                            brake_mPerS2 * period_s);
}

simulation::TubeVelocity ReactingArm::decide(const std::vector<vision::FollowedContact>& contacts,
                                             const std::optional<vision::BumpDetector::Bump>& bump,
                                             const simulation::TubePose& pose) {
    simulation::TubeVelocity asked;
    if (const auto* reaction = std::get_if<scene::BumpReaction>(&m_world.reaction)) {
        if (bump && !m_retreat)
            m_retreat = {Eigen::Rotation2Dd(pose.turn_rad) * bump->retreat.head<2>(), pose.aside_m};
        if (m_retreat) {
            const double left_m =
                reaction->retreat_m - (pose.aside_m - m_retreat->from_m).dot(m_retreat->direction);
            asked.aside_mPerS = m_retreat->direction * brakingSpeed_mPerS(left_m, m_world.limits, m_period_s);
        }
    }
    if (const auto* reaction = std::get_if<scene::FollowReaction>(&m_world.reaction)) {
        const auto seen = std::ranges::find_if(contacts, [&](const vision::FollowedContact& followed) {
            return followed.event != vision::ContactEvent::ends &&
                   (followed.contact.id == m_followed || m_followed == 0);
        });
        if (seen == contacts.end()) {
            m_followed = 0;
        } else {
            if (m_followed == 0) {
                m_followed = seen->contact.id;
                m_grasp_m = seen->contact.p_Sensor_Centre_m;
            }
            const vision::FollowMotion motion =
                vision::followMotion(m_grasp_m, seen->contact.p_Sensor_Centre_m);
            asked.turn_radPerS = reaction->gain_perS * motion.turn_rad;
            asked.along_mPerS = reaction->gain_perS * motion.along_m;
        }
    }
    return asked;
}

} // namespace teleta::scene_run
