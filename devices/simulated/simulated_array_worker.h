// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_array_config.h"
#include "devices/simulated/simulated_worker.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::simulated {

/// Makes the frames of a simulated array when they are due:
///   due_k = epoch + (k + 1) / rate + lag
/// so that a late frame does not delay the next ones. A block holds the frames that are due together.
/// Thread: run() is the worker's; open() before it; the others from any.
class SimulatedArrayWorker : public SimulatedWorker {
public:
    SimulatedArrayWorker(std::unique_ptr<core::FrameGenerator> generator, const core::StopSwitch& stopSwitch,
                         SimulatedArrayConfig config);

    void open(core::Wakeup& consumer);

    [[nodiscard]] core::SourceOutlet& outlet() { return m_outlet; }
    [[nodiscard]] const core::SourceOutlet& outlet() const { return m_outlet; }

private:
    void setState(core::DeviceState state, const std::string& message) override;
    void disconnected() override { m_discontinuity = true; }
    void makeDue(const SimulatedFaults& faults, std::int64_t now_ns) override;
    std::int64_t idle(const SimulatedFaults& faults, std::int64_t now_ns) override;
    [[nodiscard]] std::string unpluggedMessage() const override;

    void deliver(core::SampleBlock& block);
    [[nodiscard]] bool lookAtStop();

    std::unique_ptr<core::FrameGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedArrayConfig m_config;
    core::SourceDescription m_description;
    std::int64_t m_staleAfter_ns;
    core::SourceOutlet m_outlet;

    std::vector<float> m_values;
    bool m_discontinuity = false; ///< of the next block
    std::uint64_t m_stops;        ///< how often STOP was engaged, as the scene knows
};

} // namespace teleta::simulated
