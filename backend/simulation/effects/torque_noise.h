// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/base/joint_effect.h"
#include "backend/simulation/base/random_stream.h"

namespace teleta::simulation {

/// Adds Gaussian noise of a given standard deviation, independent in every joint and reading.
class TorqueNoise : public JointEffect {
public:
    TorqueNoise(std::string_view name, const scene::TorqueNoiseSpec& spec, RandomStream random)
        : JointEffect(name)
        , m_spec(spec)
        , m_random(random) {}

    void apply(const arm::JointVector& trueLink_rad, const arm::JointVector& trueMotor_rad,
               JointReading& reading) override;
    void restart() override { m_random.restart(); }

private:
    scene::TorqueNoiseSpec m_spec;
    RandomStream m_random;
};

} // namespace teleta::simulation
