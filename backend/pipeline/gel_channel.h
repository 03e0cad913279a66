// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/channel.h"
#include "backend/pipeline/gel_snapshot.h"
#include "backend/pipeline/reaction_permission.h"
#include "backend/pipeline/recorded/gel_loads.h"
#include "backend/vision/gel/gel_follower.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::pipeline {

/// Where the channel leaves copies of what passes for a recording. All members are set.
struct GelTaps {
    std::shared_ptr<core::StreamTap> pictures;  ///< all that the camera gives, cropped and flipped
    std::shared_ptr<core::StreamTap> reference; ///< as stackedReference(): the one in use, and what follows
    std::shared_ptr<core::StreamTap> contacts;  ///< as gelContactValues()
    /// Called on the channel's thread; returns at once.
    std::function<void(const GelEvent& event, std::int64_t time_ns)> event;
};

/// A flat gel with markers in the running system: a camera whose pictures are followed by a thread of its
/// own. Markers move on from picture to picture, so each picture is worked on, except one that has waited for
/// longer than kOldest_s while a newer one is there; these are counted.
///
/// Three sides:
/// - controlling thread: start(), stop();
/// - viewer (one thread, the GUI's): update(), snapshot(), popEvent(), renewReference(),
///   setMayReact();
/// - any thread: description(), status(), counters.
class GelChannel : public Channel {
public:
    static constexpr std::size_t kHistoryEvents = 1024;
    static constexpr double kOldest_s = 0.1;

    /// source: not null. file: describes the gel; its name becomes the channel's. reference: pictures of the
    /// gel at rest as stackedReference(), cropped and flipped; empty, or if it does not show the gel: the
    /// first pictures of the source show it.
    GelChannel(std::unique_ptr<core::CameraSource> source, vision::MarkerGelFile file,
               core::GreyImage reference = {});
    /// Lets an arm react to contacts. Before start(). reaction: not null. stop: outlives the channel.
    void setReaction(std::unique_ptr<GelReaction> reaction, const core::StopSwitch& stop);
    /// How the loads of its contacts follow from them; nothing: that is not known. Before start().
    void setLoads(std::optional<GelLoads> loads) { m_loads = std::move(loads); }
    ~GelChannel() override;

    /// Once. The channel's own thread is notified of its data.
    void start(core::Wakeup& data) override;
    void start() { start(m_data); }
    /// Waits for the source and for one picture at most. Idempotent.
    void stop() override;
    /// Nothing: its pictures are processed by its own thread.
    std::size_t process() override { return 0; }
    void drain() override;

    [[nodiscard]] const core::CameraDescription& description() const { return m_description; }
    [[nodiscard]] ChannelSummary summary() const override;
    [[nodiscard]] core::DeviceStatus status() const override { return m_source->status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return m_source->playback(); }
    [[nodiscard]] std::uint64_t framesProcessed() const override {
        return m_processed.load(std::memory_order_relaxed);
    }

    /// Fetches the newest snapshot; true when it changed. Viewer thread.
    bool update() { return m_snapshots.update(); }
    [[nodiscard]] const GelSnapshot& snapshot() const { return m_snapshots.front(); }
    /// 0 until the first picture has been processed.
    [[nodiscard]] std::uint64_t generation() const { return m_snapshots.generation(); }
    bool popEvent(GelEvent& event) { return m_events.pop(event); }

    /// Streams NAME-reference, NAME-camera and NAME-contacts, and the events.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;

    /// The next pictures show the gel with nothing touching it.
    void renewReference();
    /// Without a picture that can be used for so long, the arm is told to stand.
    static constexpr double kLongestGap_s = 0.25;
    /// As ReactionPermission::give(). Of a gel without an arm: nothing.
    void setMayReact(bool mayReact);

private:
    void run(const std::stop_token& stop);
    void process(core::CameraFrame frame);
    void passOver(const core::CameraFrame& frame);
    void restart(const core::CameraFrame& frame);
    /// The picture that the file describes; empty: there is none. why: the reason.
    [[nodiscard]] core::GreyImage partOf(const core::CameraFrame& frame, std::string& why) const;
    [[nodiscard]] GelEvent eventOf(GelEvent::Kind kind, const vision::GelContactState& contact) const;
    void report(const std::vector<int>& before, const vision::GelFaults& faultsBefore);
    void publish(const core::CameraFrame& frame, std::int64_t work_ns, const std::string& why);
    void publish();
    /// Of a picture that can be used.
    void react();
    /// Of none, or of one that cannot be used.
    void stand();
    /// The snapshot again, if the arm or its permission changed between two pictures.
    void publishChanges();
    /// part: a picture with which it comes.
    void takeRecordedRest(const core::GreyImage& part);
    void endContacts(const std::vector<int>& ids);
    void stackRest();
    void addEvent(GelEvent event);
    void takeTaps();
    void recordPicture(const core::CameraFrame& frame, const core::GreyImage& part);
    void recordReference(std::int64_t time_ns);
    void recordReference(const std::shared_ptr<const GelTaps>& taps, std::int64_t time_ns);
    void recordContacts(const core::CameraFrame& frame);
    [[nodiscard]] std::shared_ptr<const GelTaps> tapsInto(const std::shared_ptr<recording::StreamSink>& sink,
                                                          const std::string& name) const;

    std::unique_ptr<core::CameraSource> m_source;
    vision::MarkerGelFile m_file;
    core::CameraDescription m_description;
    core::Wakeup m_data;
    core::LatestExchange<GelSnapshot> m_snapshots;
    core::BoundedQueue<GelEvent> m_events{kHistoryEvents};
    std::atomic<bool> m_referenceWanted{false};
    std::optional<GelLoads> m_loads;
    std::unique_ptr<GelReaction> m_reaction;        ///< null: no arm reacts
    std::optional<ReactionPermission> m_permission; ///< with m_reaction
    core::LatestCopy<std::shared_ptr<const GelTaps>> m_taps;
    std::array<core::LatestCopy<std::shared_ptr<const GelTaps>>, kWatchers> m_watched;
    std::atomic<std::uint64_t> m_processed{0};

    // The thread's own.
    vision::GelFollower m_follower;
    GelSnapshot m_now;
    core::RateMeter m_rate;
    core::GreyImage m_lastImage;
    std::int64_t m_first_ns = 0;
    std::int64_t m_frame_ns = 0; ///< of the frame at hand
    double m_offset_s = 0.0;     ///< from the source's time to that of the snapshots
    double m_time_s = 0.0;
    bool m_restarts = false;        ///< a frame that was passed over did not follow from the one before
    core::GreyImage m_recordedRest; ///< that is still to be taken; empty: none is
    core::GreyImage m_rest;         ///< the pictures of the one in use, as stackedReference()
    std::int64_t m_usable_ns = 0;   ///< of the newest picture that could be used
    int m_following = 0;            ///< contact that the arm follows, or is held from following
    std::uint64_t m_passedOver = 0;
    std::uint64_t m_unusable = 0;
    std::array<std::shared_ptr<const GelTaps>, 1 + kWatchers> m_tapsInUse; ///< the recorder's first

    std::jthread m_thread;
};

} // namespace teleta::pipeline
