// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

/// See scene::LensDistortionSpec.
class LensDistortion : public CameraEffect {
public:
    LensDistortion(std::string_view name, const scene::LensDistortionSpec& spec)
        : CameraEffect(name)
        , m_spec(spec) {}

    void changeLens(vision::CameraParameters& camera) override;

private:
    scene::LensDistortionSpec m_spec;
};

} // namespace teleta::simulation
