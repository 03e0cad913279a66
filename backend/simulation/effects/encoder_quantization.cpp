// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/encoder_quantization.h"

#include <cmath>

namespace teleta::simulation {

void EncoderQuantization::apply(const arm::JointVector&, const arm::JointVector&, JointReading& reading) {
    for (double& angle_rad : reading.angle_rad)
        angle_rad = m_spec.step_rad * std::round(angle_rad / m_spec.step_rad);
}

} // namespace teleta::simulation
