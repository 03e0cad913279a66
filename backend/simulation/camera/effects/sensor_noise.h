// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/base/random_stream.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <vector>

namespace teleta::simulation {

/// See scene::SensorNoiseSpec. Normal numbers are drawn once; each row of a frame reads them from a place
/// that is drawn anew.
class SensorNoise : public CameraEffect {
public:
    SensorNoise(std::string_view name, const scene::SensorNoiseSpec& spec, RandomStream random);

    [[nodiscard]] bool changesRows() const override { return true; }
    void changeRows(cv::Mat1f& rows) override;

private:
    RandomStream m_random;
    std::vector<float> m_normal;
    float m_read2;
    float m_shot2PerLevel;
};

} // namespace teleta::simulation
