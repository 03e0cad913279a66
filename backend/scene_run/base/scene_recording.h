// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/recording/recorder.h"
#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/vision/camera/cylinder_projection.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <opencv2/core.hpp>

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
    /// untouched: the picture of the tube with which the others are compared.
    void beginCamera(const core::CameraDescription& description, const vision::CylinderCamera& camera,
                     const vision::BumpDetector::Settings& bump, const core::GreyImage& untouched);

    void beginGel(const core::CameraDescription& description, const vision::MarkerGelFile& file);

    void addFrame(double time_s, std::span<const float> values);
    void addJoints(const core::JointSample& sample);
    void addTouch(const pipeline::TouchRecord& touch);
    void addPicture(double time_s, const core::GreyImage& picture);
    void addContact(double time_s, const vision::FollowedContact& followed);
    /// Pictures of a gel at rest.
    void addGelReference(const std::vector<cv::Mat1b>& pictures);
    void addGelContact(double time_s, const vision::GelContactState& contact);
    /// Whether anything is written.
    [[nodiscard]] bool isOpen() const { return m_recorder != nullptr; }

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
    static void append(core::StreamTap& tap, double time_s, const core::GreyImage& picture);

    std::unique_ptr<recording::Recorder> m_recorder;
    Batch<float> m_frames;
    Batch<double> m_joints;
    Batch<double> m_touches;
    Batch<double> m_contacts;
    std::shared_ptr<core::StreamTap> m_pictures;
    std::shared_ptr<core::StreamTap> m_gelReference;
};

} // namespace teleta::scene_run
