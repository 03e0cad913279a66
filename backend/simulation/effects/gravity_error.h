// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/arm_inertia.h"
#include "backend/simulation/base/joint_effect.h"

namespace teleta::simulation {

/// The weight that is taken off the torques is wrong by a share of the links' true weight, so that the rest
/// moves with the posture.
///   tau += e g(q)
class GravityError : public JointEffect {
public:
    GravityError(std::string_view name, const scene::GravityErrorSpec& spec, const scene::ArmBody& body)
        : JointEffect(name)
        , m_spec(spec)
        , m_inertia(body) {}

    void apply(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
               JointReading& reading) override;

private:
    scene::GravityErrorSpec m_spec;
    ArmInertia m_inertia;
};

} // namespace teleta::simulation
