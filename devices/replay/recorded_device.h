// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/playback_worker.h"

#include <memory>
#include <utility>
#include <vector>

namespace teleta::replay {

/// Plays a recording for an array and the arm that wears it, or for a camera.
///   connecting -> live <-> paused -> finished; unreadable: lost, with the place; stop(): closed
/// At a finite speed a full queue loses frames, as it would with a device; at infinity playing waits for the
/// consumer. A playback that is finished or lost starts over with play(), and can still be searched.
/// Thread: one controlling thread.
class RecordedPlayer {
public:
    /// Error: as recording::Recording::open; refused when the stream has no frames.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(RecordedConfig config);
    /// The array is described by the file. Error: the file cannot be opened or read, has no frames, or does
    /// not fit the layout.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(CsvConfig config);

    RecordedPlayer(PlaybackConfig config, std::unique_ptr<PlaybackRecording> recording)
        : m_worker(std::move(config), std::move(recording)) {}
    ~RecordedPlayer() { stop(); }
    RecordedPlayer(const RecordedPlayer&) = delete;
    RecordedPlayer& operator=(const RecordedPlayer&) = delete;

    void start(core::Wakeup& consumer);
    void stop();
    [[nodiscard]] PlaybackWorker& worker() { return m_worker; }

private:
    PlaybackWorker m_worker;
    core::DeviceThread<PlaybackWorker> m_thread{m_worker};
};

/// The controls of a playback.
class RecordedControl : public core::PlaybackControl {
public:
    explicit RecordedControl(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}

    void play() override { worker().commands().setPlaying(true); }
    void pause() override { worker().commands().setPlaying(false); }
    void step(int frames) override { worker().commands().step(frames); }
    void setSpeed(double factor) override { worker().commands().setSpeed(factor); }
    /// Goes to the first frame at or after a time, or to the last frame, and shows it, also when paused.
    void seek(double time_s) override { worker().commands().seek(time_s); }
    void setLoop(bool loop) override { worker().commands().setLoop(loop); }
    [[nodiscard]] core::PlaybackPosition position() const override { return worker().position(); }
    [[nodiscard]] std::vector<core::PlaybackMark> marks() const override { return worker().marks(); }

    /// As PlaybackWorker's.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return worker().damagedBlocks(); }
    [[nodiscard]] core::Error error() const { return worker().error(); }

protected:
    [[nodiscard]] RecordedPlayer& player() const { return *m_player; }
    [[nodiscard]] PlaybackWorker& worker() const { return m_player->worker(); }

private:
    std::shared_ptr<RecordedPlayer> m_player;
};

/// The array of a recording as a device, with its playback control.
class RecordedArray : public core::TactileSource, public RecordedControl {
public:
    using RecordedControl::RecordedControl;
    ~RecordedArray() override { player().stop(); }

    [[nodiscard]] const core::SourceDescription& description() const override {
        return worker().config().array;
    }
    void start(core::Wakeup& consumer) override { player().start(consumer); }
    void stop() override { player().stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return static_cast<ArrayPlaybackOutlet&>(worker().outlet()).blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return worker().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }
};

/// The camera of a recording as a device, with its playback control.
class RecordedCamera : public core::CameraSource, public RecordedControl {
public:
    using RecordedControl::RecordedControl;
    ~RecordedCamera() override { player().stop(); }

    [[nodiscard]] const core::CameraDescription& description() const override {
        return *worker().config().camera;
    }
    void start(core::Wakeup& consumer) override { player().start(consumer); }
    void stop() override { player().stop(); }
    bool pop(core::CameraFrame& frame) override {
        return static_cast<CameraPlaybackOutlet&>(worker().outlet()).frames().pop(frame);
    }
    [[nodiscard]] core::DeviceStatus status() const override { return worker().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }
};

/// The arm of a recording as a device, played in step with its skin. It ignores commands.
class RecordedArm : public core::ArmSource {
public:
    explicit RecordedArm(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}
    ~RecordedArm() override { m_player->stop(); }

    [[nodiscard]] const core::ArmDescription& description() const override { return worker().config().arm; }
    void start(core::Wakeup& consumer) override { m_player->start(consumer); }
    void stop() override { m_player->stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return worker().joints(); }
    [[nodiscard]] core::DeviceStatus status() const override { return worker().jointStatus(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }
    void post(const core::ArmCommand& /*command*/) override {}
    void setProgramRunning(bool /*running*/) override {}
    void restartProgram() override {}

private:
    [[nodiscard]] PlaybackWorker& worker() const { return m_player->worker(); }

    std::shared_ptr<RecordedPlayer> m_player;
};

} // namespace teleta::replay
