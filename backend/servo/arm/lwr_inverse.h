// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/arm/lwr_kinematics.h"

#include <bitset>

namespace teleta::servo {

struct InverseSettings {
    LwrLimits limits;
    /// Length that converts turns to displacements in the manipulability and in the damping; > 0.
    double length_m = 0.4;
    double fadeManipulability =
        0.25; ///< w0: below this the inverse is damped (a comfortably bent arm has 1.6); > 0
    double highestDamping = 0.1; ///< lambda at w = 0; > 0
    double brakingTime_s = 0.1;  ///< a joint may not reach its end sooner than in this time
    LwrVector rest_rad =
        LwrVector::Zero();      ///< posture towards which the joints drift where the task leaves them free
    double restGain_perS = 0.0; ///< rate of this drift; >= 0; 0: none
};

/// Joint rates for a desired motion of the tool, and the limits that changed it.
struct JointMotion {
    LwrVector rate_radPerS = LwrVector::Zero();
    Twist achieved = Twist::Zero(); ///< J rate; the resulting motion of the tool
    double manipulability = 0.0;    ///< w = sqrt(det(J J^T)), with lengths in units of length_m
    double damping = 0.0;           ///< lambda; 0: the motion is exact except for the limits
    double scale = 1.0;             ///< below 1: all rates were scaled down to the speed limits of the joints
    std::bitset<kLwrJoints> atEnd{}; ///< joints restricted by the ends of their range

    [[nodiscard]] bool limited() const { return scale < 1.0 || atEnd.any(); }
};

/// Computes joint rates by the damped least-squares inverse of the Jacobian, within the limits of the joints:
///   rate = J^T (J J^T + lambda^2 I)^-1 (V - J z) + z
///   lambda = highestDamping (1 - w/w0) for w < w0, else 0;  z: towards the rest posture, faded by damping
/// A joint that would pass its end gets the rate that its end allows, and the others take over (again by the
/// damped inverse). Then all rates are scaled down together until no joint exceeds its speed, so that the
/// tool keeps its direction. A joint outside its range may only return. twist_Base: [v; w] of the tool's
/// origin in base axes, like the rows of the Jacobian. Non-finite inputs give rates of zero. Thread: any
/// (pure); allocates nothing. Source: Nakamura and Hanafusa, J. Dyn. Sys. Meas. Control 108 (1986) 163.
[[nodiscard]] JointMotion solveRates(const LwrVector& q_rad, const LwrJacobian& jacobian,
                                     const Twist& twist_Base, const InverseSettings& settings = {});

} // namespace teleta::servo
