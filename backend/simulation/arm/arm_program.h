// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"
#include "backend/core/interface.h"
#include "backend/scene/arm_world.h"
#include "backend/simulation/arm/flexible_arm.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace teleta::simulation {

/// Moves the references of a simulated arm from step to step, as its scene says. Thread: one.
class ArmProgram : public core::Interface {
public:
    /// Moves on by one step. torque_Nm: what the joint torque sensors read last. reference_rad: changed in
    /// place.
    virtual void advance(double step_s, const arm::JointVector& torque_Nm,
                         arm::JointVector& reference_rad) = 0;
    /// Resumes from where the references are after somebody else has moved them.
    virtual void takeOver(const arm::JointVector& reference_rad) = 0;
    [[nodiscard]] virtual bool done() const = 0;
    virtual void restart() = 0;

    /// The only object that exists now; empty: all do.
    [[nodiscard]] virtual std::optional<std::size_t> onlyObject() const { return {}; }
    /// Torques on the links of the forces that somebody exerts now.
    [[nodiscard]] virtual arm::JointVector pushTorque_Nm(const arm::Arm4Kinematics&,
                                                         const arm::JointVector&) const {
        return arm::JointVector::Zero();
    }
};

/// The program of a valid world. arm: tells where the objects are met; it is not moved.
[[nodiscard]] std::unique_ptr<ArmProgram> makeProgram(const scene::ArmWorld& world, const FlexibleArm& arm);

} // namespace teleta::simulation
