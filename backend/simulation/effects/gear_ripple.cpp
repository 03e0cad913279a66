// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

/// The flexspline of a harmonic drive bends the torque sensor at it: the reading waves with the motor's
/// angle.
///   tau += A sin(N theta)
JointEffect makeEffect(const Listed<scene::GearRippleSpec>& listed) {
    return {.name = listed.name(),
            .apply = [spec = listed.spec](const arm::JointVector&, const arm::JointVector& trueMotor_rad,
                                          JointReading& reading) {
                reading.torque_Nm +=
                    spec.amplitude_Nm * (spec.wavesPerTurn * trueMotor_rad.array()).sin().matrix();
            }};
}

} // namespace teleta::simulation
