// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs a scene with a camera in a soft tube; one with a person who probes it by runProbingScene. Frames ->
/// contacts -> reaction of the arm. Files in outFolder, beside summary.json:
///   contacts.csv   as `teleta track` writes them
///   arm.csv        time_s,turn_rad,along_m,aside_x_m,aside_y_m
///   reference.png  the tube with nothing touching it
///   recording.teleta   pictures and contacts, to be replayed; none of a scene that is probed
/// Measures: contact_error_mean_m and contact_error_p95_m, distance on the skin from each true contact that
/// is deeper than 0.6 mm to the nearest one that was found, and contacts_missed without any; bump_to_stop_s,
/// from the last frame before the true contact passes the thresholds to the command that stops the arm, null
/// when the arm did not stop or stopped before: stopped_without_bump is then 1;
/// follow_angle_error_rad and follow_axial_error_m, between the first finger's way since its contact began
/// and the arm's, when it last touches.
[[nodiscard]] core::Expected<SceneSummary> runCameraScene(const scene::Scene& scene,
                                                          const RunOptions& options);

/// Runs a scene in which a person probes the tube: contacts are found with the camera as it is designed, a
/// pair is taken from each steady touch, the camera is calibrated from the pairs and compared with the true
/// one. Files in outFolder, beside summary.json:
///   pairs.csv, camera.json, residuals.csv   as `teleta calibrate` reads and writes them
///   reference.png                           the tube with nothing touching it
/// Measures: contact_error_mean_m and contact_error_p95_m, distance from true points all over the skin to
/// where the calibrated camera locates their pixels; not_located, those of them for which it has no place;
/// holes; pairs; pairs_mistaken, taken in another hole than the noted one; mistaken_kept and right_dropped by
/// the calibration; pixel_error_mean_px of the right pairs; uncertainty_m, what the calibration itself
/// expects. Without a calibration its measures are null and `refusal` says why.
[[nodiscard]] core::Expected<SceneSummary> runProbingScene(const scene::Scene& scene,
                                                           const RunOptions& options);

} // namespace teleta::scene_run
