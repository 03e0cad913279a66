// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/arm_inertia.h"
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

/// The weight that is taken off the torques is wrong by a share of the links' true weight, so that the rest
/// moves with the posture.
///   tau += e g(q)
JointEffect makeEffect(const Listed<scene::GravityErrorSpec>& listed) {
    return {
        .name = listed.name(),
        .apply = [share = listed.spec.share, inertia = ArmInertia(listed.scene.arm().body)](
                     const arm::JointVector& trueLink_rad, const arm::JointVector&, JointReading& reading) {
            reading.torque_Nm += share * inertia.weightTorque(trueLink_rad);
        }};
}

} // namespace teleta::simulation
