// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/probing_thread.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/core/threads/mailbox.h"
#include "backend/pipeline/camera_snapshot.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/contacts/pair_collector.h"

#include <QObject>
#include <QString>

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>

namespace teleta::vision {
class ProbeWatcher;
}

namespace teleta::console {

/// What a probing found in its newest frame.
struct ProbingView {
    pipeline::CameraSnapshot snapshot; ///< image, contacts, problem
    vision::PairCollector::Phase phase = vision::PairCollector::Phase::free;
    double progress = 0.0; ///< of the steady touch, 0 .. 1
    bool recorded = false; ///< the frames come from a video
};

/// Watches a camera, or a video of one, while a person probes the tube, and reports the pixel of each steady
/// touch. The first frame that shows the skin is the reference. A lost camera is waited for; the end of a
/// video ends the probing. Opening, reading and analysing run on a separate thread, which reports only its
/// newest view. Thread: GUI; nothing blocks but the destructor, which waits for the frame or the tables being
/// computed, or for the driver of a camera that sends no frame to give up
/// (camera::VideoStream::kLongestWait_s).
class LiveProbing : public QObject {
    Q_OBJECT

public:
    using Opener = std::function<core::Expected<std::unique_ptr<core::CameraSource>>()>;
    /// An open camera without frames for this long is reported.
    static constexpr std::int64_t kSilence_ns = 3'000'000'000;

    explicit LiveProbing(QObject* parent = nullptr);
    ~LiveProbing() override;

    /// Ends a running probing first. opener: called on the probing's thread. surface: of the tube.
    void start(Opener opener, const vision::CylinderSurface& surface);
    void cancel() { m_thread.cancel(); }
    /// Takes the next frame as the reference of the untouched skin.
    void renewReference() { m_referenceWanted.store(true); }
    /// Ignores the present touch, and any touch whose pixel was not reported yet: touched() is emitted only
    /// after the probe has been lifted.
    void awaitLift() { ++m_lifts; }
    [[nodiscard]] bool isRunning() const { return m_thread.isRunning(); }

signals:
    /// Settings for the pairs that follow.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void seen(const teleta::console::ProbingView& view);
    /// The pixel of a steady touch.
    void touched(const Eigen::Vector2d& pixel);
    /// Why the camera sends nothing or is lost; empty: it is back.
    void trouble(const QString& why);
    /// The probing has failed.
    void failed(const QString& why);
    /// A video has ended.
    void ended();
    void runningChanged(bool running);

private:
    struct Run;
    void run(Run& run);
    /// Returns false if it cannot continue.
    [[nodiscard]] bool process(Run& run, const core::CameraFrame& frame);
    [[nodiscard]] bool makeWatcher(Run& run, const core::GreyImage& image);
    void show(const Run& run, const core::CameraFrame& frame);
    void tellTrouble(Run& run, const QString& why);
    void finish(const Run& run, const QString& why);

    std::atomic<bool> m_referenceWanted{false};
    std::atomic<std::uint64_t> m_lifts{0}; ///< number of lifts requested
    core::Mailbox<ProbingView> m_views;
    std::atomic<bool> m_viewTold{false};
    ProbingThread m_thread;
};

} // namespace teleta::console
