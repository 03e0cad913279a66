// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/effects/camera_effect.h"

namespace teleta::simulation {

/// See scene::MotionBlurSpec.
class MotionBlur : public CameraEffect {
public:
    MotionBlur(std::string_view name, const scene::MotionBlurSpec& spec)
        : CameraEffect(name)
        , m_spec(spec) {}

    [[nodiscard]] int moments() const override { return m_spec.samples; }
    [[nodiscard]] double before_s(int moment) const override {
        return m_spec.exposure_s * (m_spec.samples - 1 - moment) / (m_spec.samples - 1);
    }

private:
    scene::MotionBlurSpec m_spec;
};

} // namespace teleta::simulation
