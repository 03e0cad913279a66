// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/taxels/frame_analysis.h"
#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/device/temperature_drift.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/mailbox.h"
#include "backend/pipeline/channel.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch/touch_snapshot.h"
#include "backend/servo/servo_link.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::pipeline {

/// Where the channel leaves copies of what passes for a recording.
struct TouchTaps {
    std::shared_ptr<core::StreamTap> frames;       ///< raw, float32
    std::shared_ptr<core::StreamTap> features;     ///< as featureValues()
    std::shared_ptr<core::StreamTap> temperatures; ///< in degC; null: the array tells none
    std::shared_ptr<core::StreamTap> loads;        ///< as loadValues(); null: there is no calibration
};

/// One tactile array in the running system: its source, how its frames are processed, and what views may see
/// of it.
///
/// Three sides, one thread each:
/// - pipeline thread: process() drains the source's blocks and publishes a snapshot and feature samples;
/// - viewer (one thread, the GUI's): update(), snapshot(), popSample(), post(), requestTare(),
/// setTaxelGain();
/// - any thread: description(), status(), settings(), counters.
class TouchChannel : public Channel {
public:
    /// Feature samples kept for a viewer that is late: 20 s at 200 Hz. What does not fit is counted.
    static constexpr std::size_t kHistorySamples = 4096;

    /// source: not null. servo: that moves the array; null: none.
    TouchChannel(std::unique_ptr<core::TactileSource> source, ChannelSettings settings,
                 std::shared_ptr<servo::ServoLink> servo = nullptr);
    ~TouchChannel() override;

    [[nodiscard]] const core::SourceDescription& description() const { return m_source->description(); }
    /// The loads of each frame follow from its signals by this calibration; nothing: by none. Before start().
    void setLoads(std::optional<FrameLoads> loads) { m_loads = std::move(loads); }
    [[nodiscard]] ChannelSummary summary() const override;
    [[nodiscard]] core::DeviceStatus status() const override { return m_source->status(); }
    /// Whether it can be known how many frames the sensor lost (core::LossCounting).
    [[nodiscard]] bool countsLosses() const;
    /// As core::LossCounting has it.
    [[nodiscard]] std::uint64_t lostAtSite() const;
    [[nodiscard]] core::PlaybackControl* playback() override { return m_source->playback(); }
    [[nodiscard]] const std::shared_ptr<servo::ServoLink>& servo() const { return m_servo; }

    void start(core::Wakeup& data) override { m_source->start(data); }
    void stop() override { m_source->stop(); }
    void drain() override;

    /// Fetches the newest snapshot; true when it changed. Viewer thread.
    bool update() { return m_snapshots.update(); }
    [[nodiscard]] const TouchSnapshot& snapshot() const { return m_snapshots.front(); }
    /// 0 until the first frame has been processed.
    [[nodiscard]] std::uint64_t generation() const { return m_snapshots.generation(); }

    /// Takes the oldest feature sample that the viewer has not seen; every frame makes one. Viewer thread.
    bool popSample(FeatureSample& sample) { return m_samples.pop(sample); }
    [[nodiscard]] std::uint64_t samplesNotShown() const { return m_samples.overflow(); }

    /// New settings, used from the next frame on; the latest wins. What was measured of the array, its tare
    /// and the gains of its taxels, stays as it is.
    void post(ChannelSettings settings);
    /// Averages the next frames of this length (at least one frame) and uses the mean as tare.
    void requestTare(double duration_s = 0.5);
    void clearTare();
    /// New gains of the taxels, one each; empty: 1.
    void setTaxelGain(std::vector<float> gain);
    /// The settings in use, with a revision that grows by one when the pipeline takes new ones, and when the
    /// temperatures of its tare become known.
    [[nodiscard]] ChannelSettings settings() const { return m_settingsInUse.get(); }
    [[nodiscard]] std::uint64_t settingsRevision() const {
        return m_revision.load(std::memory_order_acquire);
    }

    /// The chip that has become warmer or colder by more than TemperatureDrift::kTold_K since the tare was
    /// taken, most of all; nothing: none has, there is no tare, the array tells no temperatures, or those of
    /// a tare that it was opened with are not known.
    [[nodiscard]] std::optional<core::TemperatureDrift::Move> temperatureDrift() const {
        return m_driftTold.get();
    }

    /// The loads of the newest frame; nothing: there is no calibration, or no frame came.
    [[nodiscard]] std::optional<LoadReading> newestLoads() const { return m_newestLoads.get(); }

    /// Streams NAME-frames and NAME-features; where there are any, NAME-temperatures and NAME-loads.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;
    [[nodiscard]] std::optional<recording::RecordingEvent> takeSettingsEvent() override;
    /// Who gets a copy of the raw frames besides, to calibrate the array; null: nobody. Any thread.
    void collect(std::shared_ptr<core::StreamTap> frames) { m_collector.set(std::move(frames)); }

    [[nodiscard]] std::uint64_t framesProcessed() const override {
        return m_framesProcessed.load(std::memory_order_relaxed);
    }

    /// Processes the blocks that wait when it is called. Pipeline thread. Returns the number of frames.
    std::size_t process() override { return process({}); }
    /// The same. onFrame: is shown what was found in each frame, in order; its labels are older.
    std::size_t process(const std::function<void(const TouchSnapshot&)>& onFrame);

private:
    struct TareRequest {
        bool clear = false;
        double duration_s = 0.0;
    };
    struct TareRun {
        double duration_s = 0.0;
        std::size_t frames = 0;
        std::vector<double> sum;
        std::vector<std::uint32_t> count;
        double start_s = 0.0;
    };

    void applySettings(ChannelSettings settings);
    bool takeCommands(); ///< true when the settings changed
    void processFrame(const core::SampleBlock& block, std::size_t index);
    void analyse(const core::SampleBlock& block, std::size_t index);
    void accumulateTare(const core::SampleBlock& block, std::size_t index);
    void publish();
    void tap(const TouchTaps& taps);
    void findLoads(const core::SampleBlock& block, std::size_t index);
    void takeTemperatures(std::span<const std::shared_ptr<const TouchTaps>> taps);
    [[nodiscard]] std::shared_ptr<const TouchTaps>
    tapsInto(recording::StreamSink& sink, const std::string& name, const ChannelSettings& inUse) const;

    /// The settings as the recording has them.
    struct ToldSettings {
        std::string stream; ///< of the frames; empty: nothing is recorded
        std::uint64_t revision = 0;
        std::string text;
    };

    std::unique_ptr<core::TactileSource> m_source;
    std::shared_ptr<servo::ServoLink> m_servo;
    core::ChipThermometers* m_thermometers; ///< of the source; null: it tells no temperatures
    ToldSettings m_told;                    ///< of the viewer
    ChannelSettings m_settings;
    core::LatestCopy<ChannelSettings> m_settingsInUse;
    std::atomic<std::uint64_t> m_revision{0};
    core::Mailbox<ChannelSettings> m_changes;
    core::Mailbox<std::vector<float>> m_gainChanges;
    core::Mailbox<TareRequest> m_tareRequests;
    core::LatestCopy<std::shared_ptr<const TouchTaps>> m_taps;
    std::array<core::LatestCopy<std::shared_ptr<const TouchTaps>>, kWatchers> m_watched;
    core::LatestCopy<std::shared_ptr<core::StreamTap>> m_collector;
    std::vector<double> m_recordedFeatures; ///< of the block at hand
    std::optional<FrameLoads> m_loads;
    std::vector<double> m_recordedLoads; ///< of the block at hand
    core::LatestCopy<std::optional<LoadReading>> m_newestLoads;

    contact::FrameAnalysis m_analysis;
    std::unique_ptr<TareRun> m_tareRun;
    core::TemperatureDrift m_drift;
    core::LatestCopy<std::optional<core::TemperatureDrift::Move>> m_driftTold;

    TouchSnapshot m_current;
    core::SampleBlock m_block;
    std::uint64_t m_nextFrame = 0;  ///< number of the frame after m_block
    std::uint64_t m_lostBefore = 0; ///< frames between m_block and the one before it
    core::LatestExchange<TouchSnapshot> m_snapshots;
    core::BoundedQueue<FeatureSample> m_samples;
    std::atomic<std::uint64_t> m_framesProcessed{0};
};

} // namespace teleta::pipeline
