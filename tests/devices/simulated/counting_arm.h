// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/simulated_arm_device.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace teleta::test {

/// The first joint's angle counts the steps, its torque the steps of the program, the second one's torque
/// tells the drive; references follow the jog. A skin frame every fifth step.
class CountingArm : public core::ArmGenerator {
public:
    explicit CountingArm(int programSteps = 1'000'000)
        : m_programSteps(programSteps) {}

    [[nodiscard]] core::ArmDescription description() const override {
        core::ArmDescription description;
        description.name = "counter";
        description.simulated = true;
        description.lowest_rad = {-1.0, -1.0, -1.0, -0.01};
        description.highest_rad = {1.0, 1.0, 1.0, 0.02};
        description.fastest_radPerS = {0.5, 0.5, 0.5, 0.5};
        description.hasProgram = m_programSteps > 0;
        return description;
    }
    [[nodiscard]] core::SourceDescription skinDescription() const override {
        return {.name = "counter",
                .layout = core::ArrayLayout{1, 2, 0.01},
                .unit = "N",
                .nominalRate_Hz = 200.0,
                .simulated = true};
    }
    void next(const core::ArmDemand& demand, core::JointSample& sample) override {
        ++m_steps;
        m_programDone += demand.drive == core::ArmDrive::program ? 1 : 0;
        for (std::size_t joint = 0; joint < m_reference_rad.size(); ++joint)
            m_reference_rad[joint] += 1e-3 * demand.rate_radPerS[joint];
        sample.sourceTime_s = time_s();
        sample.angle_rad = {1.0 * m_steps, 0.0, 0.0, 0.0};
        sample.torque_Nm = {1.0 * m_programDone, static_cast<double>(demand.drive), 0.0, 0.0};
        sample.reference_rad = m_reference_rad;
    }
    bool skinFrame(std::span<float> values) override {
        if (m_steps % 5 != 0)
            return false;
        std::fill(values.begin(), values.end(), static_cast<float>(m_steps));
        return true;
    }
    [[nodiscard]] double time_s() const override { return 1e-3 * m_steps; }
    [[nodiscard]] bool programDone() const override { return m_programDone >= m_programSteps; }
    void restart() override {
        m_steps = m_programDone = 0;
        m_reference_rad = core::JointVector::zeros(4);
    }

private:
    int m_programSteps;
    int m_steps = 0;
    int m_programDone = 0;
    core::JointVector m_reference_rad = core::JointVector::zeros(4);
};

/// A simulated arm on a clock of the test's.
class SimulatedArmDeviceTest : public testing::Test {
protected:
    void make(simulated::SimulatedArmConfig config = {}, int programSteps = 1'000'000) {
        config.clock = m_clock;
        m_device = std::make_unique<simulated::SimulatedArmDevice>(
            std::make_unique<CountingArm>(programSteps), m_stop, std::move(config));
        m_skin = m_device->makeSkin();
    }
    void start() {
        m_device->start(m_wakeup);
        m_clock->settle();
    }
    void advance_ms(int duration_ms) {
        for (int i = 0; i < duration_ms; ++i)
            m_clock->advance(1'000'000);
    }
    std::vector<core::JointSample> drain() {
        std::vector<core::JointSample> samples;
        core::JointSample sample;
        while (m_device->joints().pop(sample))
            samples.push_back(sample);
        return samples;
    }
    std::vector<core::SampleBlock> drainSkin() {
        std::vector<core::SampleBlock> blocks;
        core::SampleBlock block;
        while (m_skin->blocks().pop(block))
            blocks.push_back(std::move(block));
        return blocks;
    }
    void jog(const core::JointVector& rate_radPerS) {
        m_device->post({.rate_radPerS = rate_radPerS, .time_ns = m_clock->now_ns()});
    }
    [[nodiscard]] core::ArmDrive drive() const { return m_device->drive(); }
    [[nodiscard]] core::DeviceState state() const { return m_device->status().state; }

    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<simulated::SimulatedArmDevice> m_device;
    std::unique_ptr<core::TactileSource> m_skin;
};

} // namespace teleta::test
