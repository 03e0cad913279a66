// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/mailbox.h"
#include "backend/scene/camera_world.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>

namespace teleta::simulation {

/// A command moves the carrier for so long; then the arm brakes until it is commanded again.
inline constexpr double kCarrierCommand_s = 0.1;
/// How long a scene that has come to its end stands before it begins anew.
inline constexpr double kCarrierPause_s = 1.0;

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

/// What the arm does about what comes over its link. Thread: the camera's worker.
class CommandedCarrier {
public:
    /// link: not null.
    CommandedCarrier(std::shared_ptr<CarrierLink> link, double rate_Hz);

    /// The velocity for the next frame: a command acts for kCarrierCommand_s. What is asked for while the arm
    /// is held does not move it once it is free again.
    [[nodiscard]] TubeVelocity next(bool held);
    /// The world begins anew: what was asked for before was asked of the arm as it stood then.
    void restart();
    /// Tells where the arm is.
    void tell(const TubePose& pose, bool held);

private:
    std::shared_ptr<CarrierLink> m_link;
    int m_commandFrames;
    TubeVelocity m_asked;
    int m_commandAge = 0; ///< frames since the newest command
    std::uint64_t m_restarts = 0;
};

} // namespace teleta::simulation
