// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/gravity_error.h"

namespace teleta::simulation {

void GravityError::apply(const arm::JointVector& trueLink_rad, const arm::JointVector&,
                         JointReading& reading) {
    reading.torque_Nm += m_spec.share * m_inertia.weightTorque(trueLink_rad);
}

} // namespace teleta::simulation
