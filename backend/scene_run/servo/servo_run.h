// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs the scene of a servoing arm: the closed loop of simulation::ServoLoop. Files:
///   servo.csv    what was felt, wanted, done and true, one row a servo cycle (servo_log.h)
///   frames.csv   the array
///   points.csv   x_m,y_m,z_m: where the array felt the contact while it explored, in the base
/// Measures: servo_measures.h, and frames, frames_lost. Events: phases, contact that ends and begins again
/// (the world's), limits that act for the first time. Error: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runServoScene(const scene::Scene& scene,
                                                         const RunOptions& options);

} // namespace teleta::scene_run
