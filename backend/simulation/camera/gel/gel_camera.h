// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/device/scene_control.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/camera/carrier_arm.h"

#include <cstdint>
#include <memory>

namespace teleta::simulation {

/// The camera of a scene with a flat gel, and the arm that carries it as somebody else commands it by the
/// link; null: nobody. When the scene has come to its end it begins anew, but not while it is held by STOP or
/// control, nor, with an arm, before it has stood for a while; also when control asks for it. control: null
/// for nobody. Error: badInput when the scene is not valid or not of a gel.
[[nodiscard]] core::Expected<std::unique_ptr<core::CameraGenerator>>
makeGelCamera(const scene::Scene& scene, std::uint64_t seed,
              std::shared_ptr<core::SceneControl> control = nullptr,
              std::shared_ptr<CarrierLink> link = nullptr);

} // namespace teleta::simulation
