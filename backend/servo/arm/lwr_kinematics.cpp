// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_kinematics.h"

#include <cmath>
#include <numbers>

namespace teleta::servo {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Sign of the twist of +-90 degrees after each joint; 0 for the last.
constexpr std::array<double, kLwrJoints> kTwistSign = {1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 0.0};

constexpr std::array<double, kLwrJoints> kOffset_m = {
    0.310, 0.0, 0.400, 0.0, 0.390, 0.0, LwrKinematics::kWristToFlange_m};

/// A frame that is moved outwards along the chain, as the columns of its rotation and its origin.
struct Frame {
    Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    Eigen::Vector3d y = Eigen::Vector3d::UnitY();
    Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d p = Eigen::Vector3d::Zero();

    /// Over one joint: Rz(q) Tz(d) Rx(+-90 degrees).
    void advance(std::size_t joint, double q_rad) {
        const double c = std::cos(q_rad);
        const double s = std::sin(q_rad);
        const Eigen::Vector3d turned = c * y - s * x;
        x = c * x + s * y;
        p += kOffset_m[joint] * z;
        if (joint + 1 == kLwrJoints) {
            y = turned;
            return;
        }
        y = kTwistSign[joint] * z;
        z = -kTwistSign[joint] * turned;
    }

    [[nodiscard]] Eigen::Isometry3d pose() const {
        Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
        X.linear() << x, y, z;
        X.translation() = p;
        return X;
    }
};

} // namespace

LwrVector LwrLimits::highest() {
    return kDegree * LwrVector{{170.0, 120.0, 170.0, 120.0, 170.0, 120.0, 170.0}};
}

LwrVector LwrLimits::fastest() {
    return kDegree * LwrVector{{110.0, 110.0, 128.0, 128.0, 204.0, 184.0, 184.0}};
}

LwrPosture LwrKinematics::forward(const LwrVector& q_rad) const {
    LwrPosture posture;
    Frame frame;
    for (std::size_t joint = 0; joint < kLwrJoints; ++joint) {
        posture.axis[joint] = frame.z;
        posture.p_Base_Joint[joint] = frame.p;
        frame.advance(joint, q_rad[static_cast<Eigen::Index>(joint)]);
    }
    posture.X_Base_Tool = frame.pose() * m_X_Flange_Tool;
    const Eigen::Vector3d p_Base_Tool = posture.X_Base_Tool.translation();
    for (std::size_t joint = 0; joint < kLwrJoints; ++joint) {
        auto column = posture.jacobian.col(static_cast<Eigen::Index>(joint));
        column.head<3>() = posture.axis[joint].cross(p_Base_Tool - posture.p_Base_Joint[joint]);
        column.tail<3>() = posture.axis[joint];
    }
    return posture;
}

} // namespace teleta::servo
