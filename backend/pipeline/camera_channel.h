// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/mailbox.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/camera_snapshot.h"
#include "backend/pipeline/channel.h"
#include "backend/pipeline/reaction_permission.h"
#include "backend/vision/finders/contact_ladder.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>

namespace teleta::pipeline {

/// Where the channel leaves copies of what passes for a recording. All members are set.
struct CameraTaps {
    std::shared_ptr<core::StreamTap> pictures;  ///< all that the camera gives
    std::shared_ptr<core::StreamTap> reference; ///< the one in use, and each that follows
    std::shared_ptr<core::StreamTap> contacts;  ///< as contactValues()
    /// Called on the vision thread; returns at once.
    std::function<void(const CameraEvent& event, std::int64_t time_ns)> event;
};

/// One camera in the soft tube in the running system. Its frames are worked on by a thread of its own, since
/// one of them takes as long as hundreds of an array's. The newest frame wins; those that were passed over
/// are counted. A rung of the ladder is made ready by another thread: frames and STOP do not wait for it.
/// A snapshot is published for each frame, and without one when the arm, the permission or the rung change.
///
/// Three sides:
/// - controlling thread: start(), stop();
/// - viewer (one thread, the GUI's): update(), snapshot(), popEvent(), chooseRung(), renewReference(),
///   setMayReact();
/// - any thread: description(), status(), counters.
class CameraChannel : public Channel {
public:
    static constexpr int kPreview_px = 820;
    static constexpr std::size_t kArrows = 600;
    static constexpr std::size_t kHistoryEvents = 1024;
    /// Without a frame that can be used for so long, the arm is told to stand.
    static constexpr double kLongestGap_s = 0.25;

    struct Settings {
        vision::CameraTracker::Settings tracker;
        vision::ContactSettings contacts;
        core::GreyImage reference = {}; ///< the tube with nothing touching it; empty: the first frame
    };

    /// source: not null. reaction: null when no arm reacts. stop: outlives the channel.
    /// Error: refused when the default rung cannot work with this camera.
    [[nodiscard]] static core::Expected<std::shared_ptr<CameraChannel>>
    make(std::unique_ptr<core::CameraSource> source, const vision::CylinderCamera& camera,
         const core::StopSwitch& stop, std::unique_ptr<CameraReaction> reaction, const Settings& settings);
    [[nodiscard]] static core::Expected<std::shared_ptr<CameraChannel>>
    make(std::unique_ptr<core::CameraSource> source, const vision::CylinderCamera& camera,
         const core::StopSwitch& stop) {
        return make(std::move(source), camera, stop, nullptr, {});
    }
    ~CameraChannel() override;

    /// Once. The channel's own thread is notified of its data.
    void start(core::Wakeup& data) override;
    void start() { start(m_data); }
    /// Ends source and vision, and lets the arm stand; waits for one frame at most. Idempotent.
    void stop() override;
    /// Nothing: its frames are processed by its own thread.
    std::size_t process() override { return 0; }
    void drain() override;

    [[nodiscard]] const core::CameraDescription& description() const { return m_source->description(); }
    [[nodiscard]] ChannelSummary summary() const override;
    [[nodiscard]] core::DeviceStatus status() const override { return m_source->status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return m_source->playback(); }
    [[nodiscard]] core::CameraSource& source() { return *m_source; }
    [[nodiscard]] std::uint64_t framesProcessed() const override {
        return m_processed.load(std::memory_order_relaxed);
    }

    /// Fetches the newest snapshot; true when it changed. Viewer thread.
    bool update() { return m_snapshots.update(); }
    [[nodiscard]] const CameraSnapshot& snapshot() const { return m_snapshots.front(); }
    /// 0 until the first frame has been processed.
    [[nodiscard]] std::uint64_t generation() const { return m_snapshots.generation(); }
    bool popEvent(CameraEvent& event) { return m_events.pop(event); }

    /// Streams NAME-reference, NAME-camera and NAME-contacts, and the events.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;
    /// Who gets copies of pictures, contacts and events from the next ones on, and of the reference; null:
    /// nobody. Any thread.
    void record(std::shared_ptr<const CameraTaps> taps) { m_taps.set(std::move(taps)); }
    [[nodiscard]] const vision::CylinderCamera& camera() const { return m_camera; }
    [[nodiscard]] const Settings& settings() const { return m_settings; }

    /// Another rung of the ladder once it is ready; an unknown name changes nothing.
    void chooseRung(const std::string& name);
    /// The next frame shows the skin untouched.
    void renewReference();
    /// STOP takes the permission away until it is given again; while it is engaged none is given.
    void setMayReact(bool mayReact);

private:
    CameraChannel(std::unique_ptr<core::CameraSource> source, const vision::CylinderCamera& camera,
                  const core::StopSwitch& stop, std::unique_ptr<CameraReaction> reaction,
                  const Settings& settings, std::unique_ptr<vision::ContactFinder> finder,
                  std::stop_source stopping);
    /// A finder that was made ready, or why it cannot be.
    struct ReadyFinder {
        const vision::ContactRung* rung = nullptr;
        core::Expected<std::unique_ptr<vision::ContactFinder>> finder;
        cv::Mat1b reference; ///< that it has taken; empty: none
    };
    void run(const std::stop_token& stop);
    void takeWishes();
    void takeRungs();
    void makeReady(const vision::ContactRung& rung);
    void process(const core::CameraFrame& frame);
    /// A recording's, from this frame on.
    void takeReference(const core::CameraFrame& frame);
    /// Lets the arm react to a frame; contacts: null when it shows none because it cannot be used.
    void react(const std::vector<vision::FollowedContact>* contacts, std::int64_t now_ns);
    /// What no frame changes.
    void refresh(CameraSnapshot& snapshot) const;
    void publishChanges();
    void publish();
    void locate(CameraSnapshot& snapshot) const;
    void report(const std::vector<vision::FollowedContact>& contacts);
    void addEvent(CameraEvent event);
    void takeTaps();
    /// capture_s: by the source's clock, as of the pictures.
    void recordReference(std::int64_t time_ns, double capture_s);
    void recordReference(const std::shared_ptr<const CameraTaps>& taps, std::int64_t time_ns,
                         double capture_s);
    void recordContacts(const core::CameraFrame& frame, const std::vector<vision::FollowedContact>& contacts);
    [[nodiscard]] bool mayReact() const;

    std::unique_ptr<core::CameraSource> m_source;
    vision::CylinderCamera m_camera;
    ReactionPermission m_permission;
    std::unique_ptr<CameraReaction> m_reaction;
    Settings m_settings;
    core::Wakeup m_data;
    core::LatestExchange<CameraSnapshot> m_snapshots;
    core::BoundedQueue<CameraEvent> m_events{kHistoryEvents};
    core::Mailbox<std::string> m_rungs;
    std::atomic<bool> m_referenceWanted{false};
    core::Mailbox<ReadyFinder> m_ready;
    [[nodiscard]] std::shared_ptr<const CameraTaps>
    tapsInto(const std::shared_ptr<recording::StreamSink>& sink, const std::string& name) const;

    core::LatestCopy<std::shared_ptr<const CameraTaps>> m_taps;
    std::array<core::LatestCopy<std::shared_ptr<const CameraTaps>>, kWatchers> m_watched;
    std::stop_source m_stopping; ///< ends what makes a finder ready
    std::atomic<std::uint64_t> m_processed{0};

    // The vision thread's own.
    vision::CameraTracker m_tracker;
    const vision::ContactRung* m_rung;
    const vision::ContactRung* m_wantedRung = nullptr; ///< null: that in use
    const vision::ContactRung* m_makingRung = nullptr; ///< by m_maker
    const vision::ContactRung* m_refusedRung = nullptr;
    std::string m_whyRefused;
    CameraSnapshot m_now;
    core::RateMeter m_rate;
    core::GreyImage m_lastImage, m_lastPreview;
    std::int64_t m_first_ns = 0;
    std::int64_t m_frame_ns = 0;  ///< of the frame at hand
    std::int64_t m_usable_ns = 0; ///< time of the newest frame that could be used
    double m_offset_s = 0.0;      ///< from the source's time to that of the snapshots
    double m_time_s = 0.0;
    std::uint64_t m_passedOver = 0;
    std::array<std::shared_ptr<const CameraTaps>, 1 + kWatchers> m_tapsInUse; ///< the recorder's first
    int m_following = 0; ///< contact that the arm follows, or is held from following

    std::jthread m_maker;
    std::jthread m_thread;
};

} // namespace teleta::pipeline
