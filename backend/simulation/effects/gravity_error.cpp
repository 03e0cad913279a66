// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/arm_inertia.h"
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

namespace {

/// The weight that is taken off the torques is wrong by a share of the links' true weight, so that the rest
/// moves with the posture.
///   tau += e g(q)
class GravityError : public JointEffect {
public:
    explicit GravityError(const Listed<scene::GravityErrorSpec>& listed)
        : JointEffect(listed.name())
        , m_share(listed.spec.share)
        , m_inertia(listed.scene.arm().body) {}

    void apply(const arm::JointVector& trueLink_rad, const arm::JointVector&,
               JointReading& reading) override {
        reading.torque_Nm += m_share * m_inertia.weightTorque(trueLink_rad);
    }

private:
    double m_share;
    ArmInertia m_inertia;
};

} // namespace

std::unique_ptr<JointEffect> makeEffect(const Listed<scene::GravityErrorSpec>& listed) {
    return std::make_unique<GravityError>(listed);
}

} // namespace teleta::simulation
