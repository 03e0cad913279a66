// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/effects/camera_effect_factory.h"

#include "backend/simulation/camera/effects/lens_distortion.h"
#include "backend/simulation/camera/effects/marker_print_error.h"
#include "backend/simulation/camera/effects/motion_blur.h"
#include "backend/simulation/camera/effects/sensor_noise.h"
#include "backend/simulation/camera/effects/uneven_light.h"
#include "backend/simulation/camera/effects/vignetting.h"

namespace teleta::simulation {

namespace {

/// Makes the effect of one kind when the scene lists it.
template <typename Spec, typename Made, bool kRandom>
void addListed(const scene::Scene& scene, std::uint64_t seed,
               std::vector<std::unique_ptr<CameraEffect>>& effects) {
    for (const scene::Effect& listed : scene.effects) {
        const auto* spec = std::get_if<Spec>(&listed.parameters);
        if (spec == nullptr)
            continue;
        if constexpr (kRandom)
            effects.push_back(
                std::make_unique<Made>(nameOf(listed), *spec, RandomStream(seed, nameOf(listed))));
        else
            effects.push_back(std::make_unique<Made>(nameOf(listed), *spec));
    }
}

} // namespace

std::vector<std::unique_ptr<CameraEffect>> makeCameraEffects(const scene::Scene& scene, std::uint64_t seed) {
    std::vector<std::unique_ptr<CameraEffect>> effects;
    addListed<scene::LensDistortionSpec, LensDistortion, false>(scene, seed, effects);
    addListed<scene::MarkerPrintErrorSpec, MarkerPrintError, true>(scene, seed, effects);
    addListed<scene::UnevenLightSpec, UnevenLight, false>(scene, seed, effects);
    addListed<scene::VignettingSpec, Vignetting, false>(scene, seed, effects);
    addListed<scene::MotionBlurSpec, MotionBlur, false>(scene, seed, effects);
    addListed<scene::SensorNoiseSpec, SensorNoise, true>(scene, seed, effects);
    return effects;
}

} // namespace teleta::simulation
