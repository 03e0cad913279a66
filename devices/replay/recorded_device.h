// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/replay/recorded_config.h"
#include "devices/replay/recorded_worker.h"

#include <memory>
#include <utility>
#include <vector>

namespace teleta::replay {

/// What plays a recording for an array and the arm that wears it, or for a camera. Thread: one controlling
/// thread.
class RecordedPlayer {
public:
    /// Error: as recording::Recording::open; refused when the stream has no frames.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(RecordedConfig config);

    RecordedPlayer(RecordedConfig config, RecordedFacts facts)
        : m_worker(std::move(config), std::move(facts)) {}
    ~RecordedPlayer() { stop(); }
    RecordedPlayer(const RecordedPlayer&) = delete;
    RecordedPlayer& operator=(const RecordedPlayer&) = delete;

    void start(core::Wakeup& consumer) { m_thread.start(m_worker, consumer); }
    void stop() { m_thread.stop(m_worker); }
    [[nodiscard]] RecordedWorker& worker() { return m_worker; }

private:
    RecordedWorker m_worker;
    core::DeviceThread m_thread;
};

/// The controls of a recording that is played.
class RecordedControl : public core::PlaybackControl {
public:
    explicit RecordedControl(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}

    void play() override { worker().play(); }
    void pause() override { worker().pause(); }
    void step(int frames) override { worker().step(frames); }
    void setSpeed(double factor) override { worker().setSpeed(factor); }
    void seek(double time_s) override { worker().seek(time_s); }
    void setLoop(bool loop) override { worker().setLoop(loop); }
    [[nodiscard]] core::PlaybackPosition position() const override { return worker().position(); }
    [[nodiscard]] std::vector<core::PlaybackMark> marks() const override { return worker().marks(); }

    /// As RecordedWorker's.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return worker().damagedBlocks(); }
    [[nodiscard]] core::Error error() const { return worker().error(); }

protected:
    [[nodiscard]] RecordedPlayer& player() const { return *m_player; }
    [[nodiscard]] RecordedWorker& worker() const { return m_player->worker(); }

private:
    std::shared_ptr<RecordedPlayer> m_player;
};

/// The array of a recording as a device, with its playback control. States as ReplayDevice.
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
        return static_cast<RecordedArrayOutlet&>(worker().outlet()).blocks();
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
        return static_cast<RecordedCameraOutlet&>(worker().outlet()).frames().pop(frame);
    }
    [[nodiscard]] core::DeviceStatus status() const override { return worker().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }
};

/// The arm of a recording as a device, played in step with its skin. It cannot be moved: what is asked of it
/// is ignored.
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
    [[nodiscard]] RecordedWorker& worker() const { return m_player->worker(); }

    std::shared_ptr<RecordedPlayer> m_player;
};

} // namespace teleta::replay
