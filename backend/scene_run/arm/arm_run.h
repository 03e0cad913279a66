// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs the scene of an arm: its touches are evaluated as the console evaluates them and compared with the
/// world. Files:
///   joints.csv   time_s,q1..q4,tau1..tau4,ref1..ref4: rad and Nm, one row a joint sample
///   frames.csv   the skin
///   touches.csv  one row a touch: what was estimated beside what is true (touch_log.h)
///   contour.csv  x_m,y_m: the contact points in the order of touch, as `teleta contour` reads them
/// Measures of all: contact_error_mean_m, contact_error_p95_m (contact points in space), first_contact_s,
/// frames, frames_lost. Of a scene that touches objects: estimated_stiffness_n_per_m (null: only a bound is
/// known), true_stiffness_n_per_m, material; one value, or a list with one entry a touch when there are
/// several. Of one that follows a contour: shape, true_shape, contour_rms_m (distance of the spline from the
/// true outline). Error: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runArmScene(const scene::Scene& scene, const RunOptions& options);

} // namespace teleta::scene_run
