// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_recording.h"

#include <cstdint>
#include <span>

namespace teleta::scene_run {

/// What a scene's arm tells, in the folder of a run: joints.csv, frames.csv and recording.teleta. Without a
/// folder nothing is written.
class ArmLogs {
public:
    [[nodiscard]] static core::Expected<ArmLogs> open(const RunOptions& options, const scene::Scene& scene,
                                                      const core::ArmGenerator& arm);

    void add(const core::JointSample& sample);
    void addFrame(double time_s, std::span<const float> values);
    void addTouch(const pipeline::TouchRecord& touch) { m_recording.addTouch(touch); }

    [[nodiscard]] bool failed() const { return m_joints.failed() || m_skin.failed(); }
    /// Of the skin, so far.
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }
    /// Error: of the first file that could not be written.
    [[nodiscard]] core::Expected<void> finish();

private:
    ArmLogs() = default;

    RunCsv m_joints;
    RunCsv m_skin;
    SceneRecording m_recording;
    std::uint64_t m_frames = 0;
};

} // namespace teleta::scene_run
