// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/camera/effects/camera_effect.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::simulation {

/// The effects of a camera that a scene lists, in the order in which they act. Each has its own random
/// stream.
[[nodiscard]] std::vector<std::unique_ptr<CameraEffect>> makeCameraEffects(const scene::Scene& scene,
                                                                           std::uint64_t seed);

} // namespace teleta::simulation
