// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/pipeline/channel.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::pipeline {

/// The angles of a sample.
struct JointReading {
    core::JointVector angle_rad; ///< empty: none has come yet
    std::int64_t time_ns = 0;    ///< when it was read, by the steady clock
};

/// The joints of one remote arm in the running system; of an arm without a tactile skin this is all there
/// is, see ArmChannel for one with a skin.
///
/// Three sides, one thread each:
/// - pipeline thread: process() drains the joint samples and publishes them;
/// - viewer (one thread, the GUI's): popSample() and the commands of device();
/// - any thread: description(), status(), jointStatus(), chain(), meshFolder(), newestReading(), counters.
class JointChannel : public Channel {
public:
    /// Joint samples kept for a viewer that is late: 16 s at 1 kHz. What does not fit is counted.
    static constexpr std::size_t kHistorySamples = 16'384;

    /// arm: not null. chain: its joints and links, where a description of them is known. meshFolder: with the
    /// meshes that the description names; empty: none.
    explicit JointChannel(std::unique_ptr<core::ArmSource> arm,
                          std::shared_ptr<const arm_model::SerialChain> chain = nullptr,
                          std::string meshFolder = {});
    ~JointChannel() override;

    [[nodiscard]] const core::ArmDescription& description() const { return m_arm->description(); }
    [[nodiscard]] core::DeviceStatus jointStatus() const { return m_arm->status(); }
    /// Null where the arm is described by core::ArmDescription alone.
    [[nodiscard]] const std::shared_ptr<const arm_model::SerialChain>& chain() const { return m_chain; }
    [[nodiscard]] const std::string& meshFolder() const { return m_meshFolder; }
    /// The pad on one of its links; nothing: it has none, or a skin around its forearm.
    [[nodiscard]] const std::optional<core::PadPlacement>& pad() const { return m_pad; }
    /// Another channel, whose frames are this stream, is a pad of this arm: recordings and sites tell it.
    /// Before the channel is recorded or watched.
    void wearPad(const core::PadPlacement& pad, std::string framesStream);
    /// Moves the arm: post(), setProgramRunning(), restartProgram() by the viewer thread.
    [[nodiscard]] core::ArmSource& device() { return *m_arm; }

    [[nodiscard]] ChannelSummary summary() const override;
    [[nodiscard]] core::DeviceStatus status() const override { return jointStatus(); }
    [[nodiscard]] std::uint64_t framesProcessed() const override { return samplesProcessed(); }
    [[nodiscard]] core::PlaybackControl* playback() override {
        return dynamic_cast<core::PlaybackControl*>(m_arm.get());
    }

    void start(core::Wakeup& data) override { m_arm->start(data); }
    void stop() override { m_arm->stop(); }
    void drain() override;
    /// A program of its own; a recording's is over.
    [[nodiscard]] bool hasProgram() const override;
    void setProgramRunning(bool running) override { m_arm->setProgramRunning(running); }
    void restartProgram() override { m_arm->restartProgram(); }

    /// Takes the oldest joint sample that the viewer has not seen; every one comes. Viewer thread.
    bool popSample(core::JointSample& sample) { return m_samples.pop(sample); }
    /// The newest that the arm's sensor of force and torque measured; nothing: it has none, or nothing came.
    [[nodiscard]] std::optional<core::WrenchSample> newestWrench() const { return m_newestWrench.get(); }
    /// Of the newest sample; none before the first. Any thread.
    [[nodiscard]] core::JointVector newestAngles_rad() const { return newestReading().angle_rad; }
    [[nodiscard]] JointReading newestReading() const { return m_newestReading.get(); }
    [[nodiscard]] std::uint64_t samplesNotShown() const { return m_samples.overflow(); }
    [[nodiscard]] std::uint64_t samplesProcessed() const {
        return m_samplesProcessed.load(std::memory_order_relaxed);
    }

    /// Streams NAME-joints and, of an arm with a sensor of force and torque, NAME-wrench.
    void record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) override;
    void watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
               const std::string& name) override;

    /// Publishes all joint samples that wait. Pipeline thread. Returns their number.
    std::size_t process() override;

protected:
    /// The joint samples that wait now, in order of time. Pipeline thread.
    [[nodiscard]] const std::vector<core::JointSample>& takeSamples();
    /// Gives a sample to recordings and to the viewer. Pipeline thread.
    void publish(const core::JointSample& sample);
    /// skinStream: with what it is recorded; empty: nothing.
    void recordJoints(recording::StreamSink* sink, const std::string& name, const std::string& skinStream);
    void watchJoints(Watcher who, recording::StreamSink* sink, const std::string& name,
                     const std::string& skinStream);

private:
    /// Null where nothing is recorded.
    struct Taps {
        std::shared_ptr<core::StreamTap> joints;
        std::shared_ptr<core::StreamTap> wrench;
    };

    [[nodiscard]] Taps tapInto(recording::StreamSink* sink, const std::string& name,
                               const std::string& skinStream) const;
    void takeWrenches();

    std::unique_ptr<core::ArmSource> m_arm;
    std::shared_ptr<const arm_model::SerialChain> m_chain;
    std::string m_meshFolder;
    std::optional<core::PadPlacement> m_pad;
    std::string m_padStream;
    core::LatestCopy<Taps> m_taps;
    std::array<core::LatestCopy<Taps>, kWatchers> m_watched;
    std::array<Taps, 1 + kWatchers> m_tapsInUse; ///< the recorder's first; of the pipeline's thread
    std::vector<core::JointSample> m_taken;
    core::BoundedQueue<core::JointSample> m_samples;
    core::LatestCopy<std::optional<core::WrenchSample>> m_newestWrench;
    core::LatestCopy<JointReading> m_newestReading;
    std::atomic<std::uint64_t> m_samplesProcessed{0};
};

} // namespace teleta::pipeline
