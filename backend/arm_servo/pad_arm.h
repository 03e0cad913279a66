// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/servo/arm/servo_arm.h"

#include <Eigen/Geometry>

#include <memory>

namespace teleta::arm_servo {

/// An arm that is known by its URDF, with a pad on one of its links, as the servo controller sees it: the
/// damped inverse of arm_model::tipRates() for the pad's frame. All joints are slowed down together to the
/// speed limit of one. When a joint would go on towards an end of its range that is nearer than kMargin_rad,
/// no joint moves: what the others did would be another motion. Joints behind the pad stand still. Thread:
/// any (const).
class PadArm : public servo::ServoArm {
public:
    static constexpr double kMargin_rad = 0.06; ///< m of a joint that slides

    /// chain: of the arm, not null. arm: with the limits of the chain's joints. Failure: badInput when the
    /// numbers of joints differ; that of SerialChain::create().
    [[nodiscard]] static core::Expected<std::shared_ptr<const PadArm>>
    create(const std::shared_ptr<const arm_model::SerialChain>& chain, const core::ArmDescription& arm,
           const core::PadPlacement& pad);

    [[nodiscard]] std::size_t joints() const override { return m_lowest.size(); }
    [[nodiscard]] servo::SensorMotion carryOut(const core::JointVector& q_rad,
                                               const servo::Twist& twist_Base) const override;
    /// q_rad: as many finite numbers as joints().
    [[nodiscard]] Eigen::Isometry3d X_Base_Sensor(const core::JointVector& q_rad) const;

private:
    PadArm(arm_model::SerialChain toLink, const core::ArmDescription& arm, const core::PadPlacement& pad);
    [[nodiscard]] core::JointVector toLink(const core::JointVector& q_rad) const;

    arm_model::SerialChain m_toLink; ///< its joints are the first of the arm's
    Eigen::Isometry3d m_X_Link_Sensor;
    core::JointVector m_lowest;
    core::JointVector m_highest;
    core::JointVector m_fastest;
};

} // namespace teleta::arm_servo
