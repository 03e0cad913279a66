// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/scene_reaction.h"

#include <utility>
#include <variant>

namespace teleta::scene_run {

SceneReaction::SceneReaction(const scene::CameraWorld& world, double period_s,
                             std::shared_ptr<simulation::CarrierLink> link)
    : m_world(world)
    , m_period_s(period_s)
    , m_end(std::move(link)) {
    forget();
}

void SceneReaction::forget() {
    m_arm.emplace(m_world, m_period_s);
    m_end.forget();
}

void SceneReaction::react(const std::vector<vision::FollowedContact>& contacts,
                          const std::optional<vision::BumpDetector::Bump>& bump, bool allowed) {
    if (!allowed) {
        forget();
        hold();
        return;
    }
    const int bumped = bump && !m_arm->stopped() ? bump->contact : 0;
    const simulation::TubeVelocity asked = m_arm->decide(contacts, bump, m_end.pose());
    m_end.ask({.asked = asked,
               .away_mPerS = asked.aside_mPerS.norm(),
               .stopped = m_arm->stopped(),
               .bump = bumped,
               .followed = m_arm->followed()});
}

pipeline::CarrierReport SceneReaction::report() const {
    const simulation::TubePose pose = m_end.pose();
    pipeline::CarrierReport report = m_end.report();
    report.X_Base_Sensor.translation() = Eigen::Vector3d(pose.aside_m.x(), pose.aside_m.y(), pose.along_m);
    report.X_Base_Sensor.linear() =
        Eigen::AngleAxisd(pose.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return report;
}

vision::CameraTracker::Settings trackerSettings(const scene::CameraWorld& world) {
    vision::CameraTracker::Settings settings;
    if (const auto* bump = std::get_if<scene::BumpReaction>(&world.reaction))
        settings.bump = {.speed_mPerS = bump->speed_mPerS, .depth_m = bump->depth_m};
    return settings;
}

} // namespace teleta::scene_run
