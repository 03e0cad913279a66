// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

/// See scene::UnevenLightSpec.
class UnevenLight : public CameraEffect {
public:
    UnevenLight(std::string_view name, const scene::UnevenLightSpec& spec)
        : CameraEffect(name)
        , m_spec(spec) {}

    void changeLight(cv::Mat1f& light, const cv::Mat2f& places) override;

private:
    scene::UnevenLightSpec m_spec;
};

} // namespace teleta::simulation
