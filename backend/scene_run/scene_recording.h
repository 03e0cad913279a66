// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/arm_device.h"
#include "backend/core/device.h"
#include "backend/core/error.h"
#include "backend/core/stream_tap.h"
#include "backend/pipeline/touch_record.h"
#include "backend/recording/recorder.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/scene_run.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// What a scene's devices delivered, as a recording: recording.teleta of the folder. It is written as
/// recording.teleta.part and takes the place of an earlier one when it is complete. Its times are simulated.
/// Nothing is dropped: a scene that runs ahead of the disk waits. Without a folder nothing is written.
class SceneRecording {
public:
    [[nodiscard]] static core::Expected<SceneRecording> open(const RunOptions& options,
                                                             const scene::Scene& scene);

    void beginArray(const core::SourceDescription& description, const scene::Scene& scene);
    void beginArm(const core::ArmDescription& description);

    void addFrame(double time_s, std::span<const float> values);
    void addJoints(const core::JointSample& sample);
    void addTouch(const pipeline::TouchRecord& touch);

    /// Error: as Recorder::stop(); ioFailed when it cannot have its name, and then it is whole as the part
    /// file.
    [[nodiscard]] core::Expected<void> finish();

private:
    /// Frames on their way to a tap, some at once.
    template <typename Number>
    struct Batch {
        std::shared_ptr<core::StreamTap> tap;
        std::vector<std::int64_t> time_ns;
        std::vector<double> time_s;
        std::vector<Number> values;

        void add(double at_s, std::span<const Number> frame);
        void flush();
    };

    std::string m_path;
    std::unique_ptr<recording::Recorder> m_recorder;
    Batch<float> m_frames;
    Batch<double> m_joints;
    Batch<double> m_touches;
};

} // namespace teleta::scene_run
