// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/lwr_inertia.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace teleta::simulation {

namespace {

using Eigen::Vector3d;
using servo::kLwrJoints;

constexpr double kUpperArm_kg = 7.0;
constexpr double kForearm_kg = 6.0;
constexpr double kFlange_kg = 3.0;
constexpr double kInJoint_kgm2 = 0.05;

/// Adds a uniform bar between two points that turns with the first joints.
void addBar(const servo::LwrPosture& posture, int joints, const Vector3d& from, const Vector3d& to,
            double mass_kg, LwrMatrix& mass) {
    // A uniform bar is a sixth of its mass at each end and four sixths in the middle.
    const Vector3d places[]{from, 0.5 * (from + to), to};
    constexpr double kShares[]{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    for (int i = 0; i < 3; ++i) {
        Eigen::Matrix<double, 3, kLwrJoints> velocity = Eigen::Matrix<double, 3, kLwrJoints>::Zero();
        for (int j = 0; j < joints; ++j) {
            const auto joint = static_cast<std::size_t>(j);
            velocity.col(j) = posture.axis[joint].cross(Vector3d(places[i] - posture.p_Base_Joint[joint]));
        }
        mass.noalias() += kShares[i] * mass_kg * velocity.transpose() * velocity;
    }
}

} // namespace

LwrMatrix lwrMassMatrix(const servo::LwrPosture& posture) {
    const Vector3d& shoulder = posture.p_Base_Joint[1];
    const Vector3d& elbow = posture.p_Base_Joint[3];
    const Vector3d& wrist = posture.p_Base_Joint[5];
    const Vector3d flange = wrist + servo::LwrKinematics::kWristToFlange_m * posture.axis[kLwrJoints - 1];
    LwrMatrix mass = kInJoint_kgm2 * LwrMatrix::Identity();
    addBar(posture, 3, shoulder, elbow, kUpperArm_kg, mass);
    addBar(posture, 5, elbow, wrist, kForearm_kg, mass);
    addBar(posture, kLwrJoints, flange, flange, kFlange_kg, mass);
    return mass;
}

LwrMatrix modalDamping(const LwrMatrix& mass, const servo::LwrJacobian& jacobian,
                       const servo::Vector6& stiffness, double dampingRatio) {
    const Eigen::LLT<LwrMatrix> root(mass);
    LwrMatrix scaled = jacobian.transpose() * stiffness.asDiagonal() * jacobian;
    root.matrixL().solveInPlace(scaled);
    scaled.transposeInPlace();
    root.matrixL().solveInPlace(scaled);
    const Eigen::SelfAdjointEigenSolver<LwrMatrix> modes(scaled);
    const LwrMatrix turned = root.matrixL() * modes.eigenvectors();
    return 2.0 * dampingRatio * turned * modes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
           turned.transpose();
}

} // namespace teleta::simulation
