// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "devices/replay/recorded_player.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace teleta::replay {

/// The controls of a playback.
class RecordedControl : public core::PlaybackControl {
public:
    explicit RecordedControl(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}

    void play() override { player().commands().setPlaying(true); }
    void pause() override { player().commands().setPlaying(false); }
    void step(int frames) override { player().commands().step(frames); }
    void setSpeed(double factor) override { player().commands().setSpeed(factor); }
    /// Goes to the first frame at or after a time, or to the last frame, and shows it, also when paused.
    void seek(double time_s) override { player().commands().seek(time_s); }
    void setLoop(bool loop) override { player().commands().setLoop(loop); }
    [[nodiscard]] core::PlaybackPosition position() const override { return player().position(); }
    [[nodiscard]] std::vector<core::PlaybackMark> marks() const override { return player().marks(); }

    /// As RecordedPlayer's.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return player().damagedBlocks(); }
    [[nodiscard]] core::Error error() const { return player().error(); }

protected:
    [[nodiscard]] RecordedPlayer& player() const { return *m_player; }

private:
    std::shared_ptr<RecordedPlayer> m_player;
};

/// The array of a recording as a device, with its playback control.
class RecordedArray : public core::TactileSource, public core::ChipThermometers, public RecordedControl {
public:
    using RecordedControl::RecordedControl;
    ~RecordedArray() override { player().stop(); }

    [[nodiscard]] const core::SourceDescription& description() const override {
        return player().config().array;
    }
    void start(core::Wakeup& consumer) override { player().start(consumer); }
    void stop() override { player().stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return static_cast<ArrayPlaybackOutlet&>(player().outlet()).blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return player().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }
    [[nodiscard]] std::size_t chips() const override { return player().config().chips; }
    [[nodiscard]] core::BoundedQueue<core::TemperatureSample>& temperatures() override {
        return player().temperatures();
    }
};

/// The camera of a recording as a device, with its playback control.
class RecordedCamera : public core::CameraSource, public RecordedControl {
public:
    using RecordedControl::RecordedControl;
    ~RecordedCamera() override { player().stop(); }

    [[nodiscard]] const core::CameraDescription& description() const override {
        return *player().config().camera;
    }
    void start(core::Wakeup& consumer) override { player().start(consumer); }
    void stop() override { player().stop(); }
    bool pop(core::CameraFrame& frame) override {
        return static_cast<CameraPlaybackOutlet&>(player().outlet()).frames().pop(frame);
    }
    [[nodiscard]] core::DeviceStatus status() const override { return player().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }
};

/// The arm of a recording that has nothing else of it, as a device with its playback control. It ignores
/// commands.
class RecordedJoints : public core::ArmSource, public RecordedControl {
public:
    using RecordedControl::RecordedControl;
    ~RecordedJoints() override { player().stop(); }

    [[nodiscard]] const core::ArmDescription& description() const override { return player().config().arm; }
    void start(core::Wakeup& consumer) override { player().start(consumer); }
    void stop() override { player().stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override {
        return static_cast<JointPlaybackOutlet&>(player().outlet()).samples();
    }
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() override { return player().wrenches(); }
    [[nodiscard]] core::DeviceStatus status() const override { return player().outlet().status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }
};

/// The arm of a recording as a device, played in step with its skin. It ignores commands.
class RecordedArm : public core::ArmSource {
public:
    explicit RecordedArm(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}
    ~RecordedArm() override { m_player->stop(); }

    [[nodiscard]] const core::ArmDescription& description() const override { return m_player->config().arm; }
    void start(core::Wakeup& consumer) override { m_player->start(consumer); }
    void stop() override { m_player->stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_player->joints(); }
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() override { return m_player->wrenches(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_player->jointStatus(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }

private:
    std::shared_ptr<RecordedPlayer> m_player;
};

} // namespace teleta::replay
