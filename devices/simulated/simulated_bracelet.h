// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_board.h"

#include <memory>

namespace teleta::simulated {

/// A simulated bracelet that behaves like a connected one, with faults on demand, and reports how strongly
/// its motors turn. Thread: as core::BraceletSource; setFaults(), faults(), drive() and motors() from any.
class SimulatedBracelet : public core::BraceletSource {
public:
    /// stopSwitch must outlive the bracelet.
    explicit SimulatedBracelet(const core::StopSwitch& stopSwitch,
                               const SimulatedBraceletConfig& config = {});

    [[nodiscard]] const core::BraceletDescription& description() const override {
        return m_link.description();
    }
    void start(core::Wakeup& consumer) override { m_link.start(consumer); }
    void stop() override { m_link.stop(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_link.status(); }
    [[nodiscard]] core::BraceletTelemetry telemetry() const override { return m_link.telemetry(); }
    [[nodiscard]] std::uint64_t connection() const override { return m_link.connection(); }
    core::WriteResult write(const core::BraceletFrame& frame) override { return m_link.write(frame); }

    [[nodiscard]] std::optional<core::MotorSpeeds> motorSpeeds() const override {
        return m_board->motorSpeeds();
    }

    void setFaults(const BraceletFaults& faults) { m_board->setFaults(faults); }
    [[nodiscard]] BraceletFaults faults() const { return m_board->faults(); }
    /// What the motors are told now, with the board's time-out.
    [[nodiscard]] core::Drive drive() { return m_board->drive(); }
    /// How strongly the motors turn now, 0 .. 1.
    [[nodiscard]] core::Intensities motors() { return m_board->motors(); }

private:
    std::shared_ptr<SimulatedBoard> m_board;
    core::BraceletLink m_link;
};

} // namespace teleta::simulated
