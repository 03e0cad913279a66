// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/torque_noise.h"

namespace teleta::simulation {

void TorqueNoise::apply(const arm::JointVector&, const arm::JointVector&, JointReading& reading) {
    for (double& torque_Nm : reading.torque_Nm)
        torque_Nm += m_spec.sd_Nm * m_random.normal();
}

} // namespace teleta::simulation
