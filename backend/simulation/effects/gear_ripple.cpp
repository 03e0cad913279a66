// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

namespace {

/// The flexspline of a harmonic drive bends the torque sensor at it: the reading waves with the motor's
/// angle.
///   tau += A sin(N theta)
class GearRipple : public JointEffect {
public:
    explicit GearRipple(const Listed<scene::GearRippleSpec>& listed)
        : JointEffect(listed.name())
        , m_spec(listed.spec) {}

    void apply(const arm::JointVector&, const arm::JointVector& trueMotor_rad,
               JointReading& reading) override {
        reading.torque_Nm +=
            m_spec.amplitude_Nm * (m_spec.wavesPerTurn * trueMotor_rad.array()).sin().matrix();
    }

private:
    scene::GearRippleSpec m_spec;
};

} // namespace

std::unique_ptr<JointEffect> makeEffect(const Listed<scene::GearRippleSpec>& listed) {
    return std::make_unique<GearRipple>(listed);
}

} // namespace teleta::simulation
