// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "backend/scene/camera_world.h"
#include "backend/scene_run/camera/carrier_end.h"
#include "backend/scene_run/camera/reacting_arm.h"
#include "backend/simulation/camera/carrier_arm.h"

#include <memory>
#include <optional>

namespace teleta::scene_run {

/// Lets the simulated arm of a scene react as the scene says, over its link. Thread: one.
class SceneReaction : public pipeline::CameraReaction {
public:
    /// period_s: between two frames, > 0. link: not null.
    SceneReaction(const scene::CameraWorld& world, double period_s,
                  std::shared_ptr<simulation::CarrierLink> link);

    void react(const std::vector<vision::FollowedContact>& contacts,
               const std::optional<vision::BumpDetector::Bump>& bump, bool allowed) override;
    void hold() override { m_end.hold(); }
    void forget() override;
    [[nodiscard]] pipeline::CarrierReport report() const override;

private:
    scene::CameraWorld m_world;
    double m_period_s;
    CarrierEnd m_end;
    std::optional<ReactingArm> m_arm;
};

/// How the tracker of a scene's camera is set: bumps are what the scene calls so.
[[nodiscard]] vision::CameraTracker::Settings trackerSettings(const scene::CameraWorld& world);

} // namespace teleta::scene_run
