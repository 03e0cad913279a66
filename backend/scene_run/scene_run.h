// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs a scene as fast as the machine allows, through the same processing as a device's data, and compares
/// what was estimated with what the simulated world knows. Files in outFolder:
///   summary.json   see SceneSummary::toJson
///   recording.teleta   what the devices delivered, to be replayed (scene_recording.h); none of a camera
///   that is probed, whose pairs are its data
///   frames.csv     time_s,t0,t1,...: the frames of the tactile array, as `teleta features` reads them
///   of an arm: joints.csv, touches.csv, contour.csv (arm_run.h)
///   of an arm with an operator: joints.csv, touches.csv, objects.csv, bracelet.csv (arm_run.h)
///   of a servo: servo.csv, points.csv (servo_run.h)
///   of a camera, which has no frames.csv: contacts.csv, arm.csv, reference.png (camera_run.h)
///   of a flat gel, which has none either: markers.csv, contacts.csv, truth.csv (gel_run.h)
/// Same scene and seed: same bytes, but for the computing times and the recording, which has a date. Thread:
/// any; keeps one core busy. Error: badInput (the scene is not valid), ioFailed (a file cannot be written).
[[nodiscard]] core::Expected<SceneSummary> runScene(const scene::Scene& scene, const RunOptions& options);

} // namespace teleta::scene_run
