// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/scene_reaction.h"

#include <utility>
#include <variant>

namespace teleta::scene_run {

namespace {

using Doing = pipeline::CarrierReport::Doing;

/// Slower than this the arm stands.
constexpr double kStill_mPerS = 1e-4;

} // namespace

SceneReaction::SceneReaction(const scene::CameraWorld& world, double period_s,
                             std::shared_ptr<simulation::CarrierLink> link)
    : m_world(world)
    , m_period_s(period_s)
    , m_link(std::move(link)) {
    forget();
}

void SceneReaction::forget() {
    m_arm.emplace(m_world, m_period_s);
    m_doing = Doing::stands;
    m_contact = 0;
}

void SceneReaction::hold() {
    m_doing = Doing::held;
    m_link->asked.post({});
}

void SceneReaction::react(const std::vector<vision::FollowedContact>& contacts,
                          const std::optional<vision::BumpDetector::Bump>& bump, bool allowed) {
    if (!allowed) {
        forget();
        hold();
        return;
    }
    if (bump && !m_arm->stopped())
        m_contact = bump->contact;
    const simulation::TubeVelocity asked = m_arm->decide(contacts, bump, m_link->state.get().pose);
    m_link->asked.post(asked);
    m_doing = Doing::stands;
    if (m_arm->stopped()) {
        if (asked.aside_mPerS.norm() > kStill_mPerS)
            m_doing = Doing::retreats;
    } else if (m_arm->followed() != 0) {
        m_contact = m_arm->followed();
        m_doing = Doing::follows;
    }
    if (m_doing == Doing::stands && !m_arm->stopped())
        m_contact = 0;
}

pipeline::CarrierReport SceneReaction::report() const {
    const simulation::CarrierState state = m_link->state.get();
    pipeline::CarrierReport report;
    report.doing = m_doing == Doing::stands && state.held ? Doing::held : m_doing;
    report.contact = m_contact;
    report.X_Base_Sensor.translation() =
        Eigen::Vector3d(state.pose.aside_m.x(), state.pose.aside_m.y(), state.pose.along_m);
    report.X_Base_Sensor.linear() =
        Eigen::AngleAxisd(state.pose.turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return report;
}

vision::CameraTracker::Settings trackerSettings(const scene::CameraWorld& world) {
    vision::CameraTracker::Settings settings;
    if (const auto* bump = std::get_if<scene::BumpReaction>(&world.reaction))
        settings.bump = {.speed_mPerS = bump->speed_mPerS, .depth_m = bump->depth_m};
    return settings;
}

} // namespace teleta::scene_run
