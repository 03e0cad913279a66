// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

/// See scene::VignettingSpec.
class Vignetting : public CameraEffect {
public:
    Vignetting(std::string_view name, const scene::VignettingSpec& spec)
        : CameraEffect(name)
        , m_spec(spec) {}

    void changeLight(cv::Mat1f& light, const cv::Mat2f& places) override;

private:
    scene::VignettingSpec m_spec;
};

} // namespace teleta::simulation
