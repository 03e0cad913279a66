// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/arm_device.h"
#include "backend/servo/arm/lwr_kinematics.h"
#include "widgets/view3d/scene/scene_types.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace teleta::console {

// Where the joints of an arm are in space, with their ranges, for the dials of the 3-D view. The angle 0 of a
// dial points where what the joint moves lies at 0. radius_m: of what is drawn at the joint. Thread: any.

/// Of the arm with four joints. q_rad: finite.
[[nodiscard]] std::vector<view3d::JointDial> armDials(const arm::Arm4Kinematics& kinematics,
                                                      const core::ArmDescription& description,
                                                      const arm::JointVector& q_rad);
/// Of the arm of the servo scenes. Empty where an angle is not finite.
[[nodiscard]] std::vector<view3d::JointDial> servoDials(const servo::LwrVector& q_rad, double radius_m);

/// Of an arm by its description; joints that slide or turn without limits have none.
class ChainDials {
public:
    explicit ChainDials(std::shared_ptr<const arm_model::SerialChain> chain);
    /// q: as many as the chain has joints, finite.
    [[nodiscard]] std::vector<view3d::JointDial> at(const core::JointVector& q, double radius_m) const;

private:
    struct Turning {
        std::size_t joint;
        Eigen::Isometry3d X_Joint_Dial; ///< from the frame before the joint turns
    };

    std::shared_ptr<const arm_model::SerialChain> m_chain;
    std::vector<Turning> m_turning;
};

} // namespace teleta::console
