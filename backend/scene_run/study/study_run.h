// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"
#include "backend/study/session/study_scene.h"

namespace teleta::scene_run {

/// Runs the study of a scene with its simulated participants, by the rules of real sessions, and a bracelet
/// whose frames are computed. outFolder gets the study (study.sqlite, data/) and summary.json; without it
/// nothing is kept. Measures, of test trials unless stated otherwise:
///   trials, accuracy, timeouts, response_time_median_s (of right answers)
///   patterns_sent       stimuli of practice and test
///   frames, frames_lost of the bracelet
///   felt_onset_p50_s    from a stimulus' first frame until a motor has reached half of what it is told
///   felt_rms_error      between the intensity that is told and the one that is felt, over all frames and
///   tactors
/// Error: badInput, ioFailed; refused when outFolder contains a study. Thread: any.
[[nodiscard]] core::Expected<SceneSummary> runStudyScene(const study::StudyScene& scene,
                                                         const RunOptions& options);

} // namespace teleta::scene_run
