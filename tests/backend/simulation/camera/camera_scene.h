// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"

namespace teleta::test {

/// Padé approximant of atan(r) / r: an equidistant fisheye lens.
inline scene::LensDistortionSpec fisheye() {
    return {{735.0 / 945.0, 64.0 / 945.0, 0.0, 1050.0 / 945.0, 225.0 / 945.0, 0.0}, {}};
}

/// The paper's camera with all that spoils its image.
inline scene::Scene cameraScene(bool withNoise = true) {
    scene::Scene scene;
    scene.name = "camera";
    scene.duration_s = 1.0;
    scene.rate_Hz = 40.0;
    scene.world = scene::CameraWorld{};
    scene.effects.push_back({"", fisheye()});
    scene.effects.push_back({"", scene::MarkerPrintErrorSpec{.sd_m = 0.0001, .sizeShare = 0.05}});
    scene.effects.push_back({"", scene::UnevenLightSpec{.lamps = 8, .ripple = 0.3, .fallPerMetre = 3.0}});
    scene.effects.push_back({"", scene::VignettingSpec{.share = 0.3}});
    if (withNoise)
        scene.effects.push_back({"", scene::SensorNoiseSpec{.read = 1.0, .shot = 2.5}});
    return scene;
}

/// The same camera with fewer pixels, e.g. half of them across and down.
inline scene::Scene smallCameraScene(bool withNoise = true, double share = 0.5) {
    scene::Scene scene = cameraScene(withNoise);
    auto& camera = std::get<scene::CameraWorld>(scene.world).camera;
    camera.width_px = static_cast<int>(camera.width_px * share);
    camera.height_px = static_cast<int>(camera.height_px * share);
    camera.focalLength_px *= share;
    return scene;
}

} // namespace teleta::test
