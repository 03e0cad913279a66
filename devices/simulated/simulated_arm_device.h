// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_arm_worker.h"

#include <memory>

namespace teleta::simulated {

/// A simulated remote arm that behaves like a connected one: joint samples and skin frames in real time,
/// commands that are limited and die with their dead man, and faults on demand.
///   connecting -> live <-> stale; unplugged: lost -> reconnecting -> connecting; stop(): closed
/// While STOP is engaged the arm stands still and samples go on; after its release the arm is held until the
/// operator jogs it or lets the program go on. The same holds after a lost link.
/// Thread: start, stop from one controlling thread, setFaults from any; otherwise as core::ArmSource.
class SimulatedArmDevice : public core::ArmSource {
public:
    /// generator: not null, with rates above 0. stopSwitch must outlive the device and its skin.
    SimulatedArmDevice(std::unique_ptr<core::ArmGenerator> generator, const core::StopSwitch& stopSwitch,
                       SimulatedArmConfig config = {});

    /// The skin as a source of its own: it is started and stopped by this device, its own start() and stop()
    /// do nothing. It may outlive the device, and then stays closed. One at a time.
    [[nodiscard]] std::unique_ptr<core::TactileSource> makeSkin();

    [[nodiscard]] const core::ArmDescription& description() const override { return m_worker->description(); }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override {
        return m_worker->joints().samples();
    }
    void wakeAtEachSample(bool each) override { m_worker->joints().wakeAtEachSample(each); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker->joints().status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return m_worker->drive().drive(); }

    [[nodiscard]] std::uint64_t presentObjects() const override { return m_worker->presentObjects(); }

    void post(const core::ArmCommand& command) override {
        m_worker->drive().post(command, m_worker->now_ns());
    }
    void setProgramRunning(bool running) override {
        m_worker->drive().setProgramRunning(running, m_worker->now_ns());
    }
    void restartProgram() override { m_worker->drive().restartProgram(); }

    void setFaults(const SimulatedFaults& faults) { m_worker->setFaults(faults); }
    [[nodiscard]] SimulatedFaults faults() const { return m_worker->faults(); }

private:
    std::shared_ptr<SimulatedArmWorker> m_worker; ///< shared with the skin
    core::DeviceThread<SimulatedArmWorker> m_thread{*m_worker};
};

} // namespace teleta::simulated
