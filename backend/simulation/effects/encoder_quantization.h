// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/joint_effect.h"

namespace teleta::simulation {

/// Rounds each angle to the nearest multiple of the encoder's step.
class EncoderQuantization : public JointEffect {
public:
    EncoderQuantization(std::string_view name, const scene::EncoderQuantizationSpec& spec)
        : JointEffect(name)
        , m_spec(spec) {}

    void apply(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
               JointReading& reading) override;

private:
    scene::EncoderQuantizationSpec m_spec;
};

} // namespace teleta::simulation
