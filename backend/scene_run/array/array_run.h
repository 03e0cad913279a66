// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs the scene of a tactile array with indenters: its contacts are found in every frame as the console
/// finds them and compared with the centres of pressure of the true loads. Measures: contact_error_mean_m,
/// contact_error_p95_m, first_contact_s, frames, frames_lost. A load below the sensor's firing threshold is
/// none. Error: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runArrayScene(const scene::Scene& scene,
                                                         const RunOptions& options);

} // namespace teleta::scene_run
