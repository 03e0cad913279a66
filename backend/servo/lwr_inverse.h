// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/lwr_kinematics.h"

#include <tl/expected.hpp>

#include <bitset>

namespace teleta::servo {

struct InverseSettings {
    LwrLimits limits;
    /// Length that makes a speed as large as a turn in the manipulability and in the damping; > 0.
    double length_m = 0.4;
    double fadeManipulability =
        0.25;                    ///< w0: below this the inverse is damped (an arm bent at ease has 1.6); > 0
    double highestDamping = 0.1; ///< lambda at w = 0; > 0
    double brakingTime_s = 0.1;  ///< a joint nears its end by no more than what is left of it in this time
    LwrVector rest_rad =
        LwrVector::Zero();      ///< posture that the joints creep to where the task leaves them free
    double restGain_perS = 0.0; ///< >= 0; 0: they do not
};

/// Joint rates for a wanted motion of the tool, and what stood in its way.
struct JointMotion {
    LwrVector rate_radPerS = LwrVector::Zero();
    Twist achieved = Twist::Zero();  ///< J rate; what the tool will do
    double manipulability = 0.0;     ///< w = sqrt(det(J J^T)), with lengths in units of length_m
    double damping = 0.0;            ///< lambda; 0: the motion is exact but for the limits
    double scale = 1.0;              ///< below 1: all rates were lowered by the joints' speed limits
    std::bitset<kLwrJoints> atEnd{}; ///< joints that are held back by the ends of their range

    [[nodiscard]] bool limited() const { return scale < 1.0 || atEnd.any(); }
};

/// Damped least-squares inverse of the Jacobian with limits of the joints.
///   rate = J^T (J J^T + lambda^2 I)^-1 (V - J z) + z
///   lambda = highestDamping (1 - w/w0) for w < w0, else 0;  z: towards the rest posture, faded by damping
/// A joint that would pass its end is set to what its end allows and the others take over (again with the
/// damped inverse); then all rates are lowered together until no joint is faster than its limit, so that the
/// tool keeps its direction. A joint outside of its range may only return.
/// twist_Base: [v; w] of the tool's origin in base axes, as the Jacobian's rows. What is not finite gives
/// rates of zero. Thread: any (pure); nothing allocates. Source: Nakamura and Hanafusa, J. Dyn. Sys. Meas.
/// Control 108 (1986) 163.
[[nodiscard]] JointMotion solveRates(const LwrVector& q_rad, const LwrJacobian& jacobian,
                                     const Twist& twist_Base, const InverseSettings& settings = {});

enum class InverseRefusal {
    notFinite,   ///< a number of the pose or the start is NaN or infinite
    unreachable, ///< no posture within the limits was found
};

/// Joint angles at which the tool is at a pose, within 1e-9 m and 1e-9 rad, found by steps of solveRates from
/// a start. Of the many that a redundant arm has, the one that the steps come to.
[[nodiscard]] tl::expected<LwrVector, InverseRefusal> solvePose(const LwrKinematics& kinematics,
                                                                const Eigen::Isometry3d& X_Base_Tool,
                                                                const LwrVector& start_rad,
                                                                const InverseSettings& settings = {});

} // namespace teleta::servo
