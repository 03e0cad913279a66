// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs the scene of a servoing arm: the closed loop of simulation::ServoLoop. Files:
///   servo.csv    what was felt, wanted, done and true, one row a servo cycle: columns named _true are the
///                world's own, _desired the controller's; contact is none, touching, searching or lost, type
///                none, point or edge; x, y, z and q are the pose of the array in the base, v and w its
///                commanded twist in {s}; energy_J is that of the simulated arm; limits names those that
///                acted, with + between them; coc_x_desired_m of a slide is the CoP_x that is wanted, as the
///                paper draws it; mass_x_true_m is of a weight on a tray
///   frames.csv   the array
///   points.csv   x_m,y_m,z_m: where the array felt the contact while it explored, in the base
/// Measures: servo_measures.h, and frames, frames_lost. Verdict: servo_verdict.h; none when interrupted.
/// Events: phases, contact that ends and begins again (the world's), limits that act for the first time.
/// Error: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runServoScene(const scene::Scene& scene,
                                                         const RunOptions& options);

} // namespace teleta::scene_run
