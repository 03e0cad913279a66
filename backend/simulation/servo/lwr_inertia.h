// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/arm/lwr_kinematics.h"

#include <Eigen/Core>

namespace teleta::simulation {

using LwrMatrix = Eigen::Matrix<double, servo::kLwrJoints, servo::kLwrJoints>;

/// Inertia of the seven-joint arm: 16 kg, the mass of the KUKA LWR 4+, as uniform bars from shoulder to elbow
/// and from elbow to wrist and a point mass at the flange, and what turns in each joint about its axis. How
/// the mass is spread over the links is assumed; at the speeds of servoing the stiffness carries the load.
/// Symmetric and positive definite. kg m^2. Thread: any (pure).
[[nodiscard]] LwrMatrix lwrMassMatrix(const servo::LwrPosture& posture);

/// Damping in joint space that gives every mode of the arm on the spring J^T K J this damping ratio:
///   M = L L^T,  L^-1 J^T K J L^-T = U W^2 U^T,  D = 2 zeta L U W U^T L^T
/// Defined in singular postures too; directions without stiffness are left undamped. K: 6 diagonal values >=
/// 0.
[[nodiscard]] LwrMatrix modalDamping(const LwrMatrix& mass, const servo::LwrJacobian& jacobian,
                                     const servo::Vector6& stiffness, double dampingRatio);

} // namespace teleta::simulation
