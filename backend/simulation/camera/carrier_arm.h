// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/mailbox.h"
#include "backend/scene/camera_world.h"

#include <Eigen/Core>

#include <cstdint>

namespace teleta::simulation {

/// Where the tube is: turned about its axis, moved along it and aside, from where it started.
struct TubePose {
    double turn_rad = 0.0;
    double along_m = 0.0;
    Eigen::Vector2d aside_m = Eigen::Vector2d::Zero(); ///< x, y of the base
};

/// What the arm is asked to do.
struct TubeVelocity {
    double turn_radPerS = 0.0;
    double along_mPerS = 0.0;
    Eigen::Vector2d aside_mPerS = Eigen::Vector2d::Zero();
};

/// The arm that carries the tube: it takes on a velocity as fast as its limits allow. Thread: one.
class CarrierArm {
public:
    explicit CarrierArm(const scene::CarrierLimits& limits)
        : m_limits(limits) {}

    void step(const TubeVelocity& asked, double dt_s);

    [[nodiscard]] const TubePose& pose() const { return m_pose; }
    [[nodiscard]] const TubeVelocity& velocity() const { return m_velocity; }

private:
    scene::CarrierLimits m_limits;
    TubePose m_pose;
    TubeVelocity m_velocity;
};

/// State of the arm that carries a tube.
struct CarrierState {
    TubePose pose;
    bool held = false;          ///< by STOP, or because no commands come any more
    std::uint64_t restarts = 0; ///< of the world
};

/// Connects the arm that carries a tube with what commands it. Thread: asked.take and state.set by the
/// camera's worker; asked.post and state.get from any.
struct CarrierLink {
    core::Mailbox<TubeVelocity> asked;
    core::LatestCopy<CarrierState> state;
};

} // namespace teleta::simulation
