// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

/// Rounds each angle to the nearest multiple of the encoder's step.
JointEffect makeEffect(const Listed<scene::EncoderQuantizationSpec>& listed) {
    return {.name = listed.name(),
            .apply = [step_rad = listed.spec.step_rad](const arm::JointVector&, const arm::JointVector&,
                                                       JointReading& reading) {
                for (double& angle_rad : reading.angle_rad)
                    angle_rad = step_rad * std::round(angle_rad / step_rad);
            }};
}

} // namespace teleta::simulation
