// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/gear_ripple.h"

#include <cmath>

namespace teleta::simulation {

void GearRipple::apply(const arm::JointVector&, const arm::JointVector& trueMotor_rad,
                       JointReading& reading) {
    reading.torque_Nm += m_spec.amplitude_Nm * (m_spec.wavesPerTurn * trueMotor_rad.array()).sin().matrix();
}

} // namespace teleta::simulation
