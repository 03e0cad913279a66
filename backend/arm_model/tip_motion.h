// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/joint_vector.h"

#include <Eigen/Core>

namespace teleta::arm_model {

/// Velocity of the tip in the base frame.
struct TipTwist {
    Eigen::Vector3d velocity_mPerS = Eigen::Vector3d::Zero();
    Eigen::Vector3d turn_radPerS = Eigen::Vector3d::Zero();
};

/// Joint rates for a twist of the tip, and what becomes of the twist.
struct TipRates {
    core::JointVector rate; ///< rad/s, prismatic m/s
    double followed = 1.0;  ///< share of the twist that the rates carry out, 0..1; small near a singularity
    /// Damping acts: the tip is slower than asked. Directions which an arm of few joints moves in no pose do
    /// not count.
    bool singular = false;
};

/// Joint rates that move the tip with a twist, by least squares that are damped where the arm is near a
/// singularity:
///   rate = sum over singular values s_i of s_i / (s_i^2 + d_i^2) (u_i . twist) v_i
///   d_i^2 = (e/2)^2 (1 - (s_i/e)^2) for s_i < e, else 0;   e = kLeastLever_m
/// Rows of the angular velocity are weighted with kTurnLength_m, so that both halves are lengths. Only
/// directions along which the arm can hardly move are slowed down, and rates stay below 1.2 |twist| / e. With
/// fewer than six joints the twist that can be reached and lies nearest is carried out. Directions which no
/// joint moves at all lower `followed`. Zeros when a number is not finite. Thread: any (pure). Source:
/// Nakamura and Hanafusa (1986); damping per singular value as in arm::solveContactForce().
[[nodiscard]] TipRates tipRates(const SerialChain& chain, const core::JointVector& q, const TipTwist& twist);

/// A turn of 1 rad counts as much as a way of this length.
inline constexpr double kTurnLength_m = 0.2;
/// Directions in which the tip moves less than this for a turn of the joints by 1 rad are damped.
inline constexpr double kLeastLever_m = 0.02;

} // namespace teleta::arm_model
