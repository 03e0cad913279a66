// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_joints.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/modbus/played_server.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace teleta;
using namespace teleta::modbus;
using core::DeviceState;
using test::eventually;
using test::ManualClock;
using test::PlayedServer;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr Answer kTimedOut{Answer::Kind::timedOut};
constexpr Answer kException{Answer::Kind::exception, 2};
constexpr Answer kLost{Answer::Kind::lost};

/// Angles in mrad in 100..103, torques in mN m in 200..203, at 100 Hz.
RegisterMap armMap() {
    RegisterMap map;
    map.name = "arm";
    map.inputRate_Hz = 100.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const RegisterFormat format{.type = RegisterType::int16, .scale = 0.001};
        map.inputs.push_back({.name = "a" + std::to_string(i),
                              .address = static_cast<std::uint16_t>(100 + i),
                              .format = format,
                              .unit = "rad"});
        map.inputs.push_back({.name = "t" + std::to_string(i),
                              .address = static_cast<std::uint16_t>(200 + i),
                              .format = format,
                              .unit = "N m"});
        map.joints.push_back({.angle = 2 * i, .torque = 2 * i + 1});
    }
    return map;
}

class ModbusJointsTest : public testing::Test {
protected:
    void start(ModbusJointsConfig config = {}) {
        config.clock = m_clock;
        m_device = std::make_unique<ModbusJoints>(armMap(), m_server.opener(), m_arm, std::move(config));
        m_device->start(m_wakeup);
        m_clock->settle();
    }
    void advance_ms(int duration_ms) {
        for (int i = 0; i < duration_ms; i += 10)
            m_clock->advance(10 * kMs_ns);
    }
    std::vector<core::JointSample> drain() {
        std::vector<core::JointSample> samples;
        core::JointSample sample;
        while (m_device->joints().pop(sample))
            samples.push_back(sample);
        return samples;
    }
    [[nodiscard]] DeviceState state() const { return m_device->status().state; }

    core::ArmDescription m_arm;
    PlayedServer m_server;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
    std::unique_ptr<ModbusJoints> m_device;
};

} // namespace

TEST_F(ModbusJointsTest, readsTheJointsWhenTheyAreDueAndStampsThem) {
    for (std::uint16_t i = 0; i < 4; ++i) {
        m_server.set(static_cast<std::uint16_t>(100 + i), static_cast<std::uint16_t>(10 * (i + 1)));
        m_server.set(static_cast<std::uint16_t>(200 + i), static_cast<std::uint16_t>(-500 * (i + 1)));
    }
    const std::int64_t begin_ns = m_clock->now_ns();
    start();
    advance_ms(490);
    const std::vector<core::JointSample> samples = drain();
    ASSERT_EQ(samples.size(), 50U);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        EXPECT_EQ(samples[k].time_ns, begin_ns + static_cast<std::int64_t>(k) * 10 * kMs_ns);
        EXPECT_DOUBLE_EQ(samples[k].sourceTime_s, 0.01 * static_cast<double>(k));
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_DOUBLE_EQ(samples[k].angle_rad[i], 0.01 * static_cast<double>(i + 1));
            EXPECT_DOUBLE_EQ(samples[k].torque_Nm[i], -0.5 * static_cast<double>(i + 1));
            EXPECT_EQ(samples[k].reference_rad[i], samples[k].angle_rad[i]);
        }
        EXPECT_FALSE(samples[k].discontinuity);
    }
    EXPECT_EQ(m_server.reads(), 100) << "one request for the angles, one for the torques";
    const core::DeviceStatus status = m_device->status();
    EXPECT_EQ(status.state, DeviceState::live);
    EXPECT_EQ(status.framesRead, 50U);
    EXPECT_EQ(status.framesLost, 0U);
    EXPECT_NEAR(status.rate_Hz, 100.0, 1e-6);
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
}

TEST_F(ModbusJointsTest, cannotMoveTheArm) {
    m_arm.upperArmLength_m = 0.3;
    m_arm.fastest_radPerS = {1, 1, 1, 1};
    m_arm.hasProgram = true;
    start();
    const core::ArmDescription& arm = m_device->description();
    EXPECT_EQ(arm.name, "arm");
    EXPECT_EQ(arm.nominalRate_Hz, 100.0);
    EXPECT_EQ(arm.upperArmLength_m, 0.3);
    EXPECT_EQ(arm.fastest_radPerS, core::JointVector::zeros(4));
    EXPECT_FALSE(arm.hasProgram);
    m_device->post({.rate_radPerS = {1, 1, 1, 1}, .time_ns = m_clock->now_ns()});
    m_device->setProgramRunning(true);
    m_device->restartProgram();
    advance_ms(50);
    EXPECT_EQ(m_device->drive(), core::ArmDrive::held);
    EXPECT_TRUE(m_server.takeWrites().empty());
}

TEST_F(ModbusJointsTest, livesThroughASingleFailureAndCountsIt) {
    start();
    advance_ms(50);
    for (const Answer& answer : {kTimedOut, kException}) {
        m_server.answerNext({answer});
        advance_ms(10);
        EXPECT_EQ(state(), DeviceState::live);
        EXPECT_EQ(m_device->status().message, describe(answer));
        advance_ms(10);
        EXPECT_EQ(m_device->status().message, "");
    }
    EXPECT_EQ(m_device->status().framesLost, 2U);
    EXPECT_EQ(m_server.connections(), 1);
}

TEST_F(ModbusJointsTest, isLostAfterSeveralFailuresAndConnectsAgainLessAndLessOften) {
    start();
    advance_ms(50);
    drain();
    m_server.setReachable(false);
    m_server.answerNext({kTimedOut, kTimedOut, kTimedOut});
    advance_ms(30);
    EXPECT_EQ(state(), DeviceState::lost);
    EXPECT_EQ(m_device->status().message, describe(kTimedOut));
    m_clock->advance(100 * kMs_ns); // tried again, in vain
    EXPECT_EQ(m_device->status().message, "nobody listens");
    m_server.setReachable(true);
    m_clock->advance(199 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::lost);
    EXPECT_EQ(m_server.connections(), 1);
    m_clock->advance(1 * kMs_ns);
    EXPECT_EQ(m_server.connections(), 2);
    EXPECT_EQ(state(), DeviceState::live);
    advance_ms(10);
    const std::vector<core::JointSample> samples = drain();
    ASSERT_EQ(samples.size(), 2U);
    EXPECT_TRUE(samples[0].discontinuity);
    EXPECT_FALSE(samples[1].discontinuity);
    EXPECT_EQ(m_device->status().framesLost, 3U);
}

TEST_F(ModbusJointsTest, isLostAtOnceWhenTheConnectionIs) {
    start();
    advance_ms(50);
    m_server.answerNext({kLost});
    advance_ms(10);
    EXPECT_EQ(state(), DeviceState::lost);
    EXPECT_EQ(m_device->status().message, describe(kLost));
}

TEST_F(ModbusJointsTest, goesStaleWhileEveryAnswerIsAnException) {
    start({.failuresUntilLost = 100});
    advance_ms(50);
    for (int i = 0; i < 20; ++i)
        m_server.answerNext({kException});
    advance_ms(90);
    EXPECT_EQ(state(), DeviceState::live);
    advance_ms(30);
    EXPECT_EQ(state(), DeviceState::stale);
    EXPECT_EQ(m_device->status().message, describe(kException));
    advance_ms(100);
    EXPECT_EQ(state(), DeviceState::live);
}

TEST_F(ModbusJointsTest, isLostFromTheStartWhenNobodyListens) {
    m_server.setReachable(false);
    start();
    EXPECT_EQ(state(), DeviceState::lost);
    EXPECT_EQ(m_device->status().message, "nobody listens");
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
}

TEST_F(ModbusJointsTest, countsTheReadingsThatItWasTooLateFor) {
    start();
    m_clock->advance(55 * kMs_ns);
    EXPECT_EQ(drain().size(), 2U) << "the first one, and one for the five that were due";
    EXPECT_EQ(m_device->status().framesLost, 4U);
    m_clock->advance(5 * kMs_ns);
    EXPECT_EQ(drain().size(), 1U) << "the schedule is kept";
}

TEST_F(ModbusJointsTest, countsWhatAFullQueueLoses) {
    start({.queueSamples = 4});
    advance_ms(90);
    EXPECT_EQ(m_device->status().framesRead, 10U);
    EXPECT_EQ(m_device->status().framesLost, 6U);
}

TEST_F(ModbusJointsTest, startsAnewAfterStop) {
    start();
    advance_ms(50);
    m_device->stop();
    drain();
    m_device->start(m_wakeup);
    m_clock->settle();
    const std::vector<core::JointSample> samples = drain();
    ASSERT_EQ(samples.size(), 1U);
    EXPECT_TRUE(samples[0].discontinuity);
    EXPECT_EQ(m_device->status().framesRead, 1U);
}

TEST(ModbusJoints, needAMapWithJoints) {
    RegisterMap map = armMap();
    map.joints.clear();
    const auto device = makeModbusJoints(map, core::ArmDescription());
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, core::ErrorKind::refused);
}

TEST(InputReader, readsEachInputInItsUnitAndNothingAfterAFailure) {
    PlayedServer server;
    server.set(10, 0x3F00); // 0.5 as float32
    server.set(11, 0x0000);
    server.set(12, static_cast<std::uint16_t>(-7));
    server.set(20, 9);
    const auto input = [](std::uint16_t address, RegisterType type) {
        return InputRegister{.name = {}, .address = address, .format = {.type = type}, .unit = "1"};
    };
    InputReader reader(
        {input(20, RegisterType::uint16), input(12, RegisterType::int16), input(10, RegisterType::float32)});
    EXPECT_EQ(reader.requests(), 2U);
    auto link = server.opener()();
    ASSERT_TRUE(link);
    std::vector<double> values(3);
    EXPECT_TRUE(reader.read(**link, values).done());
    EXPECT_EQ(values, (std::vector<double>{9.0, -7.0, 0.5}));
    server.answerNext({Answer{}, kException});
    EXPECT_EQ(reader.read(**link, values), kException);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], -7.0);
}
