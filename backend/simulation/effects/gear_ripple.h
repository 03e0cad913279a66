// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/joint_effect.h"

namespace teleta::simulation {

/// The flexspline of a harmonic drive bends the torque sensor at it: the reading waves with the motor's
/// angle.
///   tau += A sin(N theta)
class GearRipple : public JointEffect {
public:
    GearRipple(std::string_view name, const scene::GearRippleSpec& spec)
        : JointEffect(name)
        , m_spec(spec) {}

    void apply(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
               JointReading& reading) override;

private:
    scene::GearRippleSpec m_spec;
};

} // namespace teleta::simulation
