// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/device/scene_control.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/camera/carrier_arm.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <cstdint>
#include <memory>

namespace teleta::simulation {

/// The camera of a scene with a soft tube, and the arm that carries it as somebody else commands it by the
/// link. The first frame shows the tube untouched. When the scene has come to its end it begins anew, but not
/// while it is held; also when control asks for it, which holds it as STOP does. Deterministic while nobody
/// commands the arm or the scene.
struct TubeCameraSource {
    std::unique_ptr<core::CameraGenerator> generator;
    vision::CylinderCamera camera;
};
/// link: not null. control: null for nobody. Error: badInput when the scene is not valid or not of a camera.
[[nodiscard]] core::Expected<TubeCameraSource>
makeTubeCamera(const scene::Scene& scene, std::uint64_t seed, std::shared_ptr<CarrierLink> link,
               std::shared_ptr<core::SceneControl> control = nullptr);

} // namespace teleta::simulation
