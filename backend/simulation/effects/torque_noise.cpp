// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

namespace teleta::simulation {

namespace {

/// Adds Gaussian noise of a given standard deviation, independent in every joint and reading.
class TorqueNoise : public JointEffect {
public:
    explicit TorqueNoise(const Listed<scene::TorqueNoiseSpec>& listed)
        : JointEffect(listed.name())
        , m_sd_Nm(listed.spec.sd_Nm)
        , m_random(listed.random()) {}

    void apply(const arm::JointVector&, const arm::JointVector&, JointReading& reading) override {
        for (double& torque_Nm : reading.torque_Nm)
            torque_Nm += m_sd_Nm * m_random.normal();
    }

    void restart() override { m_random.restart(); }

private:
    double m_sd_Nm;
    core::RandomStream m_random;
};

} // namespace

std::unique_ptr<JointEffect> makeEffect(const Listed<scene::TorqueNoiseSpec>& listed) {
    return std::make_unique<TorqueNoise>(listed);
}

} // namespace teleta::simulation
