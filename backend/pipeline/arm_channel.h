// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/mailbox.h"
#include "backend/pipeline/joint_channel.h"
#include "backend/pipeline/touch/found_objects.h"
#include "backend/pipeline/touch/skin_touches.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/pipeline/touch/touch_estimator.h"
#include "backend/pipeline/touch/touch_history.h"
#include "backend/pipeline/touch_channel.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::pipeline {

/// How one arm's samples are turned into touches and a contour; changed while it runs.
struct ArmSettings {
    TouchEstimatorSettings touch;
    ContourSettings contour;
};

/// What the pipeline knows about one arm after its newest sample. Views get it as a constant.
struct ArmSnapshot {
    core::JointSample newest;
    core::ArmDrive drive = core::ArmDrive::held;
    /// Steady time of the first sample since the arm started over, which shows when its own time runs back;
    /// objects and touches are of the time since. 0: it has not started over. Seeking in a recording does not
    /// count.
    std::int64_t begun_ns = 0;
    std::optional<LiveContact> contact;
    std::optional<TouchRecord> lastTouch;
    ExploredContour contour; ///< of the object that was touched last
    std::vector<FoundObject> objects;
    std::uint64_t objectsRevision = 0; ///< grows with each change of the objects
    std::uint64_t samplesProcessed = 0;
};

/// One remote arm with its skin in the running system: evaluates its touches and the contour that they
/// outline, and says what views may see of it. The skin's own picture is that of its TouchChannel.
///
/// Three sides, one thread each:
/// - pipeline thread: process() drains skin and joints and publishes a snapshot, joint samples and touches;
/// - viewer (one thread, the GUI's): as of JointChannel, and update(), snapshot(), popTouch(), post(),
///   resetContour();
/// - any thread: as of JointChannel, and settings().
class ArmChannel : public JointChannel {
public:
    /// Touches kept for a viewer that is late; counted as well.
    static constexpr std::size_t kHistoryTouches = 1024;

    /// arm: not null. skin: of the same arm, not null.
    ArmChannel(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
               const ArmSettings& settings = {});
    /// An arm that is known by its URDF, with a pad on one of its links, and with the torques of touches that
    /// the pad's placement says. chain: not null. meshFolder: as of JointChannel. Error: that of padOnLink().
    [[nodiscard]] static core::Expected<std::shared_ptr<ArmChannel>>
    withPad(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
            std::shared_ptr<const arm_model::SerialChain> chain, const core::PadPlacement& pad,
            std::string meshFolder = {});
    ~ArmChannel() override;

    [[nodiscard]] ChannelSummary summary() const override {
        ChannelSummary summary = m_skin->summary();
        summary.guarded = description().guarded;
        return summary;
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_skin->status(); }
    [[nodiscard]] std::uint64_t framesProcessed() const override { return m_skin->framesProcessed(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return m_skin->playback(); }
    [[nodiscard]] const std::shared_ptr<TouchChannel>& skin() const { return m_skin; }

    void start(core::Wakeup& data) override;
    void stop() override;
    void drain() override;

    /// Fetches the newest snapshot; true when it changed. Viewer thread.
    bool update() { return m_snapshots.update(); }
    [[nodiscard]] const ArmSnapshot& snapshot() const { return m_snapshots.front(); }
    /// 0 until the first sample or skin frame has been processed.
    [[nodiscard]] std::uint64_t generation() const { return m_snapshots.generation(); }

    /// Takes the oldest touch that the viewer has not seen. Viewer thread.
    bool popTouch(TouchRecord& touch) { return m_touches.pop(touch); }
    [[nodiscard]] std::uint64_t touchesNotShown() const { return m_touches.overflow(); }

    /// New settings, used from the next samples on; the latest wins.
    void post(const ArmSettings& settings) { m_changes.post(settings); }
    /// Who is told of every touch on the pipeline thread, from the next touch on; null for nobody.
    void setFeedback(std::shared_ptr<TactileFeedback> feedback) { m_feedback.set(std::move(feedback)); }
    /// What is touched next is another object: begins a new contour before the next samples are processed.
    void resetContour() { m_contourReset.store(true, std::memory_order_release); }
    /// The settings in use.
    [[nodiscard]] ArmSettings settings() const { return m_settingsInUse.get(); }

    /// Streams NAME-joints and NAME-touches, and those of the skin.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;
    [[nodiscard]] std::optional<recording::RecordingEvent> takeSettingsEvent() override {
        return m_skin->takeSettingsEvent();
    }

    /// Processes all joint samples and skin frames that wait, in order of time. Pipeline thread. Returns the
    /// number of joint samples.
    std::size_t process() override;

private:
    /// skinAt: null for the skin around a forearm.
    ArmChannel(std::unique_ptr<core::ArmSource> arm, std::shared_ptr<TouchChannel> skin,
               const ArmSettings& settings, std::shared_ptr<const SkinKinematics> skinAt,
               std::shared_ptr<const arm_model::SerialChain> chain, std::string meshFolder);

    bool takeCommands(); ///< true when a view may see a change
    void take(TouchRecord&& touch);
    /// Adds it to the objects. Of a recording, a touch that is played again is not another one.
    void addToObjects(const TouchRecord& touch, TouchHistory::Kind kind);
    /// What was found before is of another run.
    void beginAnew(std::int64_t time_ns);
    void publishSnapshot();

    std::shared_ptr<TouchChannel> m_skin;
    TouchEstimator m_estimator;
    SkinTouches m_skinTouches;   ///< in its place, of an arm that measures no torques
    bool m_tellsTorques = false; ///< any sample so far did
    FoundObjects m_found;
    TouchHistory m_history; ///< of a recording
    std::uint64_t m_objectsRevision = 0;
    std::int64_t m_begun_ns = 0; ///< see ArmSnapshot
    std::optional<double> m_sourceTime_s;

    core::Mailbox<ArmSettings> m_changes;
    core::LatestCopy<ArmSettings> m_settingsInUse;
    std::atomic<bool> m_contourReset{false};
    core::LatestCopy<std::shared_ptr<TactileFeedback>> m_feedback;
    core::LatestCopy<std::shared_ptr<core::StreamTap>> m_touchTap;
    std::array<core::LatestCopy<std::shared_ptr<core::StreamTap>>, kWatchers> m_touchesWatched;

    std::vector<SkinContact> m_contacts;
    core::JointSample m_newest;
    std::optional<TouchRecord> m_lastTouch;
    core::LatestExchange<ArmSnapshot> m_snapshots;
    core::BoundedQueue<TouchRecord> m_touches;
};

} // namespace teleta::pipeline
