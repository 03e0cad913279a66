// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/scene_control.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_worker.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::simulated {

struct SimulatedArrayConfig {
    std::size_t queueBlocks = 256;
    /// Age of the newest frame from which the data is stale; by default core::staleAfter_ns of the frame
    /// rate.
    std::optional<double> staleAfter_s = std::nullopt;
    /// A worker that is later than this does not catch up: the simulated world then stood still meanwhile.
    double longestCatchUp_s = 1.0;
    SimulatedFaults faults{};
    std::uint64_t faultSeed = 1; ///< which frames are dropped
    /// Null: nobody holds or restarts it, and after STOP it goes on.
    std::shared_ptr<core::SceneControl> scene = nullptr;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

/// A simulated tactile array that behaves like a connected one: frames in real time, and faults on demand. A
/// block holds the frames that are due together.
///   connecting -> live <-> stale; unplugged: lost -> reconnecting -> connecting; stop(): closed
/// While STOP is engaged or the scene is held, the simulated motion stands still and frames go on.
/// Thread: start, stop from one controlling thread, setFaults from any; otherwise as core::TactileSource.
class SimulatedArrayDevice : public core::TactileSource, private SimulatedWorker {
public:
    /// generator: not null, with a frame rate above 0. stopSwitch must outlive the device.
    SimulatedArrayDevice(std::unique_ptr<core::FrameGenerator> generator, const core::StopSwitch& stopSwitch,
                         SimulatedArrayConfig config = {});

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_outlet.blocks(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    using SimulatedWorker::faults;
    using SimulatedWorker::setFaults;

private:
    friend core::DeviceThread<SimulatedArrayDevice>;
    void open(core::Wakeup& consumer) { m_outlet.open(consumer, now_ns()); }

    void setState(core::DeviceState state, const std::string& message) override {
        m_outlet.setState(state, now_ns(), message);
    }
    void disconnected() override { m_discontinuity = true; }
    void makeDue(const SimulatedFaults& faults, std::int64_t now_ns) override;
    std::int64_t idle(const SimulatedFaults& /*faults*/, std::int64_t now_ns) override {
        return watchAge(m_outlet, m_staleAfter_ns, now_ns);
    }
    [[nodiscard]] std::string unpluggedMessage() const override;

    void deliver(core::SampleBlock& block);
    [[nodiscard]] bool lookAtStop();

    std::unique_ptr<core::FrameGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedArrayConfig m_config;
    core::SourceDescription m_description;
    std::int64_t m_staleAfter_ns;
    core::SourceOutlet m_outlet;

    // The worker's own.
    std::vector<float> m_values;
    bool m_discontinuity = false; ///< of the next block
    std::uint64_t m_stops;        ///< how often STOP was engaged, as the scene knows

    core::DeviceThread<SimulatedArrayDevice> m_thread{*this};
};

} // namespace teleta::simulated
