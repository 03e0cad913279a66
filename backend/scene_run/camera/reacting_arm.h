// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/carrier_arm.h"
#include "backend/vision/contacts/camera_tracker.h"

#include <optional>

namespace teleta::scene_run {

/// As fast as an arm can still brake after another period before it has gone so far: v^2 / 2a + v T = left,
/// with a fifth of its acceleration to spare. Thread: any (pure).
[[nodiscard]] double brakingSpeed_mPerS(double left_m, const scene::CarrierLimits& limits, double period_s);

/// Turns what the tracker sees into what the arm is asked to do: draw back after a bump, follow the oldest
/// contact. Thread: one.
class ReactingArm {
public:
    /// period_s: between two frames, > 0; a command acts for so long before the next one.
    ReactingArm(const scene::CameraWorld& world, double period_s)
        : m_world(world)
        , m_period_s(period_s) {}

    /// The velocity for the time until the next frame. pose: of the arm as its encoders say.
    [[nodiscard]] simulation::TubeVelocity decide(const std::vector<vision::FollowedContact>& contacts,
                                                  const std::optional<vision::BumpDetector::Bump>& bump,
                                                  const simulation::TubePose& pose);

    /// The arm was stopped by a bump.
    [[nodiscard]] bool stopped() const { return m_retreat.has_value(); }
    /// Identity of the contact that is followed; 0: none.
    [[nodiscard]] int followed() const { return m_followed; }

private:
    struct Retreat {
        Eigen::Vector2d direction; ///< in the base
        Eigen::Vector2d from_m;
    };
    const scene::CameraWorld& m_world;
    double m_period_s;
    std::optional<Retreat> m_retreat;
    int m_followed = 0;                                  ///< identity of the contact that is followed
    Eigen::Vector3d m_grasp_m = Eigen::Vector3d::Zero(); ///< where on the skin it is to stay
};

} // namespace teleta::scene_run
