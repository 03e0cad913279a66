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
///   touches.csv  one row a touch: what was estimated beside what is true (writeTouches)
///   contour.csv  x_m,y_m: the contact points in the order of touch, as `teleta contour` reads them
/// Measures of all: contact_error_mean_m, contact_error_p95_m (contact points in space), first_contact_s,
/// frames, frames_lost. Of a scene that touches objects: estimated_stiffness_n_per_m (null: only a bound is
/// known), true_stiffness_n_per_m, material; one value, or a list with one entry a touch when there are
/// several; stiffness_error_mean, stiffness_covered (reportStiffnessCovered). Of one that follows a contour:
/// shape, true_shape, contour_rms_m (distance of the spline from the true outline). Error: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runArmScene(const scene::Scene& scene, const RunOptions& options);

/// Runs a scene with an operator at another place: link -> arm -> link -> touches -> objects -> patterns ->
/// frames of the bracelet, all in simulated time, in which computing takes none. Logs what the operator's
/// side has:
///   joints.csv, frames.csv, touches.csv   as above
///   objects.csv     a row an object: object,first_s,touches,contact_type,x_m,y_m,force_n,
///                   stiffness_n_per_m,stiffness_lower_95,stiffness_upper_95,material,shape,confidence,
///                   true_object,true_stiffness_n_per_m,true_shape
///   bracelet.csv    SimulatedPlayer
/// Measures with one value an object of the scene, in its order, null when it was not found:
/// estimated_stiffness_n_per_m, true_stiffness_n_per_m, material, shape, true_shape. touch_to_tactor: from
/// the sample, at the arm, that completed a touch to the first frame of its pattern. frames_lost: of the
/// skin, on the link. Error and thread: as runScene.
[[nodiscard]] core::Expected<SceneSummary> runTeleoperation(const scene::Scene& scene,
                                                            const RunOptions& options);

} // namespace teleta::scene_run
