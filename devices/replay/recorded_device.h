// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/arm_device.h"
#include "backend/core/device.h"
#include "backend/core/device_thread.h"
#include "backend/core/error.h"
#include "devices/replay/recorded_config.h"
#include "devices/replay/recorded_worker.h"

#include <memory>

namespace teleta::replay {

/// What plays a recording for an array and the arm that wears it. Thread: one controlling thread.
class RecordedPlayer {
public:
    /// Error: as recording::Recording::open; refused when the array's stream has no frames.
    [[nodiscard]] static core::Expected<std::shared_ptr<RecordedPlayer>> open(RecordedConfig config);

    RecordedPlayer(RecordedConfig config, const recording::Recording::Extent& extent, std::int64_t start_ns)
        : m_worker(std::move(config), extent, start_ns) {}
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

/// The array of a recording as a device, with its playback control. States as ReplayDevice.
class RecordedArray : public core::TactileSource, public core::PlaybackControl {
public:
    explicit RecordedArray(std::shared_ptr<RecordedPlayer> player)
        : m_player(std::move(player)) {}
    ~RecordedArray() override { m_player->stop(); }

    [[nodiscard]] const core::SourceDescription& description() const override {
        return worker().config().array;
    }
    void start(core::Wakeup& consumer) override { m_player->start(consumer); }
    void stop() override { m_player->stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return worker().outlet().blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return worker().outlet().status(); }
    [[nodiscard]] core::PlaybackControl* playback() override { return this; }

    void play() override { worker().play(); }
    void pause() override { worker().pause(); }
    void step(int frames) override { worker().step(frames); }
    void setSpeed(double factor) override { worker().setSpeed(factor); }
    void seek(double time_s) override { worker().seek(time_s); }
    void setLoop(bool loop) override { worker().setLoop(loop); }
    [[nodiscard]] core::PlaybackPosition position() const override { return worker().position(); }

    /// As RecordedWorker's.
    [[nodiscard]] std::uint64_t damagedBlocks() const { return worker().damagedBlocks(); }
    [[nodiscard]] core::Error error() const { return worker().error(); }

private:
    [[nodiscard]] RecordedWorker& worker() const { return m_player->worker(); }

    std::shared_ptr<RecordedPlayer> m_player;
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
