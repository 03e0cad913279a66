// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/gel/gel_scene_reaction.h"

#include "backend/scene_run/camera/reacting_arm.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace teleta::scene_run {

namespace {

using simulation::TubeVelocity;

} // namespace

ReactingGel::ReactingGel(const scene::GelWorld& world, double period_s)
    : m_reaction(world.reaction)
    , m_limits(world.limits)
    , m_period_s(period_s) {
    if (const auto* bump = std::get_if<scene::GelBumpReaction>(&m_reaction))
        m_bumps.emplace(vision::BumpDetector::Settings{bump->spread_mPerS, bump->spread_m});
}

TubeVelocity ReactingGel::decide(const std::vector<vision::GelContactState>& contacts, double time_s,
                                 double noise_m, const simulation::TubePose& pose) {
    m_bump = 0;
    if (const auto* bump = std::get_if<scene::GelBumpReaction>(&m_reaction)) {
        const auto found = m_bumps->next(contacts, time_s, m_period_s, noise_m);
        m_bump = found ? found->contact : 0;
        if (found && !m_from_m)
            m_from_m = pose.along_m;
        return retreat(*bump, pose.along_m);
    }
    if (const auto* follows = std::get_if<scene::FollowReaction>(&m_reaction))
        return follow(*follows, contacts);
    return {};
}

TubeVelocity ReactingGel::retreat(const scene::GelBumpReaction& reaction, double along_m) const {
    TubeVelocity asked;
    if (m_from_m)
        asked.along_mPerS =
            brakingSpeed_mPerS(reaction.retreat_m - (along_m - *m_from_m), m_limits, m_period_s);
    return asked;
}

TubeVelocity ReactingGel::follow(const scene::FollowReaction& reaction,
                                 const std::vector<vision::GelContactState>& contacts) {
    TubeVelocity asked;
    auto seen = std::ranges::find(contacts, m_followed, &vision::GelContactState::id);
    if (seen == contacts.end()) {
        seen = std::ranges::min_element(contacts, {}, &vision::GelContactState::id);
        m_followed = seen == contacts.end() ? 0 : seen->id;
    }
    if (m_followed != 0)
        asked.aside_mPerS = reaction.gain_perS * seen->shearProxy_m;
    return asked;
}

GelSceneReaction::GelSceneReaction(const scene::GelWorld& world, double period_s,
                                   std::shared_ptr<simulation::CarrierLink> link)
    : m_world(world)
    , m_period_s(period_s)
    , m_end(std::move(link)) {
    forget();
}

void GelSceneReaction::forget() {
    m_arm.emplace(m_world, m_period_s);
    m_end.forget();
}

int GelSceneReaction::react(const std::vector<vision::GelContactState>& contacts, double time_s,
                            double noise_m, bool allowed) {
    if (!allowed) {
        forget();
        hold();
        return 0;
    }
    const bool wasStopped = m_arm->stopped();
    const TubeVelocity asked = m_arm->decide(contacts, time_s, noise_m, m_end.pose());
    m_end.ask({.asked = asked,
               .away_mPerS = asked.along_mPerS,
               .stopped = m_arm->stopped(),
               .bump = wasStopped ? 0 : m_arm->bump(),
               .followed = m_arm->followed()});
    return m_arm->bump();
}

pipeline::CarrierReport GelSceneReaction::report() const {
    const simulation::TubePose pose = m_end.pose();
    pipeline::CarrierReport report = m_end.report();
    // z of the gel points to what presses, and along is away from it.
    report.X_Base_Sensor.translation() = Eigen::Vector3d(pose.aside_m.x(), pose.aside_m.y(), -pose.along_m);
    return report;
}

} // namespace teleta::scene_run
