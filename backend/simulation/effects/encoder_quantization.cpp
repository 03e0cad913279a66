// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/listed_effects.h"

#include <cmath>

namespace teleta::simulation {

namespace {

/// Rounds each angle to the nearest multiple of the encoder's step.
class EncoderQuantization : public JointEffect {
public:
    explicit EncoderQuantization(const Listed<scene::EncoderQuantizationSpec>& listed)
        : JointEffect(listed.name())
        , m_step_rad(listed.spec.step_rad) {}

    void apply(const arm::JointVector&, const arm::JointVector&, JointReading& reading) override {
        for (double& angle_rad : reading.angle_rad)
            angle_rad = m_step_rad * std::round(angle_rad / m_step_rad);
    }

private:
    double m_step_rad;
};

} // namespace

std::unique_ptr<JointEffect> makeEffect(const Listed<scene::EncoderQuantizationSpec>& listed) {
    return std::make_unique<EncoderQuantization>(listed);
}

} // namespace teleta::simulation
