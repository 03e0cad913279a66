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

/// What a probing sees in its newest frame.
struct ProbingView {
    pipeline::CameraSnapshot snapshot; ///< image, contacts, problem
    vision::PairCollector::Phase phase = vision::PairCollector::Phase::free;
    double progress = 0.0; ///< of a touch that must be steady, 0 .. 1
    bool recorded = false; ///< the frames are those of a video
};

/// Watches a camera, or a video of one, while a person probes the tube, and tells the pixel of each steady
/// touch. The first frame that shows the skin is the reference. A camera that is lost is awaited; a video
/// ends the probing. Opening, reading and finding run on a thread of its own, and of the views only the
/// newest is told. Thread: GUI; no call waits but the destructor, for the frame or the tables that are
/// computed just now, or for a camera that gives no frame until its driver gives up
/// (camera::VideoStream::kLongestWait_s).
class LiveProbing : public QObject {
    Q_OBJECT

public:
    using Opener = std::function<core::Expected<std::unique_ptr<core::CameraSource>>()>;
    /// A camera that is open and gives no frame for so long is told of.
    static constexpr std::int64_t kSilence_ns = 3'000'000'000;

    explicit LiveProbing(QObject* parent = nullptr);
    ~LiveProbing() override;

    /// Ends one that runs. opener: called on the probing's thread. surface: of the tube.
    void start(Opener opener, const vision::CylinderSurface& surface);
    void cancel() { m_thread.cancel(); }
    /// The next frame shows the skin untouched.
    void renewReference() { m_referenceWanted.store(true); }
    /// A touch that goes on now, or whose pixel was not told yet, belongs to what was probed until now: it
    /// does not count, and touched() comes only after the probe was lifted.
    void awaitLift() { ++m_lifts; }
    [[nodiscard]] bool isRunning() const { return m_thread.isRunning(); }

signals:
    /// What the pairs that follow are to be calibrated with.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void seen(const teleta::console::ProbingView& view);
    /// The pixel of a steady touch.
    void touched(const Eigen::Vector2d& pixel);
    /// The camera is silent or lost, and why; empty: it is back.
    void trouble(const QString& why);
    /// It cannot be done.
    void failed(const QString& why);
    /// A video is over.
    void ended();
    void runningChanged(bool running);

private:
    struct Run;
    void run(Run& run);
    /// False when it cannot go on.
    [[nodiscard]] bool process(Run& run, const core::CameraFrame& frame);
    [[nodiscard]] bool makeWatcher(Run& run, const core::GreyImage& image);
    void show(const Run& run, const core::CameraFrame& frame);
    void tellTrouble(Run& run, const QString& why);
    void finish(const Run& run, const QString& why);

    std::atomic<bool> m_referenceWanted{false};
    std::atomic<std::uint64_t> m_lifts{0}; ///< how often a lift was asked for
    core::Mailbox<ProbingView> m_views;
    std::atomic<bool> m_viewTold{false};
    ProbingThread m_thread;
};

} // namespace teleta::console
