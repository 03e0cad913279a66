// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/contact_force.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <memory>

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::pipeline {

/// A point of an arm's skin in one pose of the arm. With a bent skin, distance and side are those of
/// core::SkinPlacement; with a flat pad
///   contactDistance_m  distance of the point from the axis of the joint that presses
///   side_rad           angle between the pad's normal and the way that this joint moves the point
struct SkinPoint {
    double contactDistance_m = 0.0;
    double side_rad = 0.0;
    Eigen::Vector3d p_Base_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal_Base = Eigen::Vector3d::UnitZ(); ///< out of the skin
    arm::AnyPointJacobian jacobian;                         ///< J_c of the point; a column a joint

    /// Depth that an angle of the pressing joint presses.
    [[nodiscard]] double lever_m() const { return contactDistance_m * std::abs(std::cos(side_rad)); }
    /// How much deeper an angle of each joint presses: J_c^T n.
    [[nodiscard]] arm::AnyJointVector depthPerAngle_m() const { return jacobian.transpose() * normal_Base; }
};

/// Where an arm's skin is, and what yields when it is pressed. Thread: any (const); at() allocates nothing.
class SkinKinematics {
public:
    virtual ~SkinKinematics() = default;

    /// The point (x, y) of the skin's frame {s}. angle_rad: finite, one a joint.
    [[nodiscard]] virtual SkinPoint at(const core::JointVector& angle_rad, double x_m, double y_m) const = 0;

    [[nodiscard]] std::size_t joints() const { return m_springs.stiffness_NmPerRad.size(); }
    /// The joint whose torque and angle give the stiffness of what is touched.
    [[nodiscard]] std::size_t pressingJoint() const { return m_pressing; }
    /// Stiffness of the arm at a point of its skin: its joints' springs in series,
    ///   1/k_ri = sum of d_i^2 / K_i,  d_i = depthPerAngle_m()
    /// with lever^2 in place of d^2 for the joint that presses. kRigid_NPerM where none yields.
    [[nodiscard]] double linkStiffness_NPerM(const SkinPoint& point) const;
    /// Its standard error, from that of the pressing joint's spring.
    [[nodiscard]] double linkStiffnessSe_NPerM(const SkinPoint& point) const;
    /// See core::SkinPlacement::centreSe_m.
    [[nodiscard]] double centreSe_m() const { return m_centreSe_m; }

    static constexpr double kRigid_NPerM = 1e9;

protected:
    struct Springs {
        core::JointVector stiffness_NmPerRad; ///< 0: rigid
        double pressingSe_NmPerRad = 0.0;
    };
    SkinKinematics(std::size_t pressing, Springs springs, double centreSe_m)
        : m_pressing(pressing)
        , m_springs(springs)
        , m_centreSe_m(centreSe_m) {}

private:
    std::size_t m_pressing;
    Springs m_springs;
    double m_centreSe_m;
};

/// The skin around the forearm of an arm of arm::Arm4Kinematics. Null: it has another number of joints.
[[nodiscard]] std::shared_ptr<const SkinKinematics> skinAroundForearm(const core::ArmDescription& arm);

/// A flat pad on an arm that is known by its URDF. chain: not null. Error: notFound, the arm has no such link
/// or joint; badInput, joints that are not the chain's move the link, or the joint does not press the pad: it
/// slides or is behind the pad. Without a named joint the last one that has a lever of kLeastLever_m or more
/// in half of all poses is taken; badInput where none has.
[[nodiscard]] core::Expected<std::shared_ptr<const SkinKinematics>>
padOnLink(const std::shared_ptr<const arm_model::SerialChain>& chain, const core::PadPlacement& pad);

/// Pose of the pad's frame in its link's.
[[nodiscard]] Eigen::Isometry3d X_Link_Sensor(const core::PadPlacement& pad);

inline constexpr double kLeastLever_m = 0.02;

} // namespace teleta::pipeline
