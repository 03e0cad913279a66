// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

/// Adds Gaussian noise of a given standard deviation, independent in every joint and reading.
JointEffect makeEffect(const Listed<scene::TorqueNoiseSpec>& listed) {
    return {.name = listed.name(),
            .apply = [sd_Nm = listed.spec.sd_Nm, random = listed.random()](
                         const arm::JointVector&, const arm::JointVector&, JointReading& reading) mutable {
                for (double& torque_Nm : reading.torque_Nm)
                    torque_Nm += sd_Nm * random.normal();
            }};
}

} // namespace teleta::simulation
