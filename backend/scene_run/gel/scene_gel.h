// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/vision/gel/marker_gel_file.h"

namespace teleta::scene_run {

/// The sensor file that fits the gel of a scene. scene: of a gel. Thread: any (pure).
[[nodiscard]] vision::MarkerGelFile gelFile(const scene::Scene& scene);

} // namespace teleta::scene_run
