// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/arm/teleoperated_arm.h"
#include "devices/simulated/simulated_arm_device.h"
#include "tests/devices/simulated/counting_arm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace teleta;
using core::ArmDrive;
using core::DeviceState;
using core::JointVector;
using simulated::SimulatedArmConfig;
using simulated::SimulatedArmDevice;
using simulated::SimulatedFaults;
using test::CountingArm;
using test::eventually;
using test::SimulatedArmDeviceTest;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;

ArmDrive driveOf(const core::JointSample& sample) {
    return static_cast<ArmDrive>(static_cast<int>(sample.torque_Nm[1]));
}

} // namespace

TEST_F(SimulatedArmDeviceTest, isClosedConnectingLiveAndClosedAgainWithItsSkin) {
    make();
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_EQ(m_skin->status().state, DeviceState::closed);
    start();
    EXPECT_EQ(state(), DeviceState::connecting);
    advance_ms(1);
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_EQ(m_skin->status().state, DeviceState::connecting) << "its first frame is due after 5 ms";
    advance_ms(4);
    EXPECT_EQ(m_skin->status().state, DeviceState::live);
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
    EXPECT_EQ(m_skin->status().state, DeviceState::closed);
    m_device->stop();
    m_device.reset();
    EXPECT_EQ(m_skin->description().name, "counter") << "the skin may outlive the device";
    EXPECT_EQ(drainSkin().size(), 1U);
}

TEST_F(SimulatedArmDeviceTest, deliversEverySampleWhenItIsDueAndStampsIt) {
    make();
    const std::int64_t begin_ns = m_clock->now_ns();
    start();
    m_clock->advance(kMs_ns - 1);
    EXPECT_TRUE(drain().empty());
    m_clock->advance(1);
    advance_ms(999);
    const auto samples = drain();
    ASSERT_EQ(samples.size(), 1000U);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto number = static_cast<std::int64_t>(i + 1);
        ASSERT_EQ(samples[i].time_ns, begin_ns + number * kMs_ns);
        ASSERT_EQ(samples[i].angle_rad[0], static_cast<double>(number));
        ASSERT_FALSE(samples[i].discontinuity);
    }
    const core::DeviceStatus status = m_device->status();
    EXPECT_EQ(status.framesRead, 1000U);
    EXPECT_EQ(status.framesLost, 0U);
    EXPECT_NEAR(status.rate_Hz, 1000.0, 1e-6);

    const auto frames = drainSkin();
    ASSERT_EQ(frames.size(), 200U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto step = static_cast<std::int64_t>(5 * (i + 1));
        ASSERT_EQ(frames[i].firstFrame, i);
        ASSERT_EQ(frames[i].time_ns[0], begin_ns + step * kMs_ns);
        ASSERT_EQ(frames[i].sourceTime_s[0], 1e-3 * static_cast<double>(step));
        ASSERT_EQ(frames[i].frame(0)[1], static_cast<float>(step));
    }
    EXPECT_NEAR(m_skin->status().rate_Hz, 200.0, 1e-6);
}

TEST_F(SimulatedArmDeviceTest, keepsItsRateWhenItWakesLate) {
    make();
    start();
    m_clock->advance(503 * kMs_ns + kMs_ns / 2);
    EXPECT_EQ(drain().size(), 503U);
    m_clock->advance(kMs_ns / 2);
    EXPECT_EQ(drain().size(), 1U) << "the next one is not delayed";
    m_clock->advance(3600'000 * kMs_ns);
    EXPECT_EQ(drain().size(), 1U) << "a long standstill is not caught up";
}

TEST_F(SimulatedArmDeviceTest, countsWhatAFullQueueLoses) {
    make({.queueSamples = 100});
    start();
    advance_ms(500);
    EXPECT_EQ(m_device->status().framesRead, 500U);
    EXPECT_EQ(m_device->status().framesLost, 400U);
    EXPECT_EQ(drain().size(), 100U);
}

TEST_F(SimulatedArmDeviceTest, runsItsProgramToTheEndAndHoldsThen) {
    make({}, 30);
    start();
    advance_ms(30);
    EXPECT_EQ(drive(), ArmDrive::program);
    advance_ms(10);
    EXPECT_EQ(drive(), ArmDrive::held);
    const auto samples = drain();
    EXPECT_EQ(driveOf(samples[29]), ArmDrive::program);
    EXPECT_EQ(driveOf(samples[30]), ArmDrive::held);
    EXPECT_EQ(samples.back().torque_Nm[0], 30.0);
}

TEST_F(SimulatedArmDeviceTest, holdsAndResumesItsProgram) {
    make();
    start();
    advance_ms(10);
    m_device->setProgramRunning(false);
    advance_ms(10);
    EXPECT_EQ(drive(), ArmDrive::held);
    EXPECT_EQ(drain().back().torque_Nm[0], 10.0);
    m_device->setProgramRunning(true);
    advance_ms(5);
    EXPECT_EQ(drive(), ArmDrive::program);
    EXPECT_EQ(drain().back().torque_Nm[0], 15.0);

    make({.startProgram = false});
    start();
    advance_ms(5);
    EXPECT_EQ(drive(), ArmDrive::held);
    make({}, 0); // has no program
    start();
    m_device->setProgramRunning(true);
    advance_ms(5);
    EXPECT_EQ(drive(), ArmDrive::held);
}

TEST_F(SimulatedArmDeviceTest, beginsTheWorldAnewAndSaysSo) {
    make({}, 30);
    start();
    advance_ms(52);
    drain();
    drainSkin();
    m_device->restartProgram();
    advance_ms(5);
    const auto samples = drain();
    ASSERT_EQ(samples.size(), 5U);
    EXPECT_TRUE(samples[0].discontinuity);
    EXPECT_FALSE(samples[1].discontinuity);
    EXPECT_EQ(samples[0].sourceTime_s, 1e-3);
    EXPECT_EQ(driveOf(samples[0]), ArmDrive::program);
    const auto frames = drainSkin();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_TRUE(frames[0].discontinuity);
}

TEST_F(SimulatedArmDeviceTest, jogsWhileCommandsComeAndStandsStillWithoutThem) {
    make();
    start();
    advance_ms(10);
    for (int i = 0; i < 10; ++i) {
        jog({0.1, 0.0, 0.0, 0.0});
        advance_ms(33);
        EXPECT_EQ(drive(), ArmDrive::jog);
    }
    // The last command was given 33 ms ago: it counts for the rest of its 100 ms.
    advance_ms(67);
    EXPECT_EQ(drive(), ArmDrive::jog);
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::held);
    advance_ms(1000);
    EXPECT_EQ(drive(), ArmDrive::held) << "the program does not go on by itself";
    const auto samples = drain();
    EXPECT_NEAR(samples.back().reference_rad[0], 0.1 * 1e-3 * (330 + 67), 1e-12);
    EXPECT_EQ(samples.back().torque_Nm[0], 10.0);
    m_device->setProgramRunning(true);
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::program);
}

TEST_F(SimulatedArmDeviceTest, takesARateOfZeroForNoWish) {
    make();
    start();
    jog({0.0, -0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
    advance_ms(5);
    EXPECT_EQ(drive(), ArmDrive::program);
    jog({0.1, 0.0, 0.0, 0.0});
    advance_ms(5);
    jog({});
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::held);
}

TEST_F(SimulatedArmDeviceTest, limitsSpeedsAndTakesNaNAsZero) {
    make();
    start();
    advance_ms(1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    jog({10.0, -infinite, nan, 0.0});
    advance_ms(100);
    const JointVector reference_rad = drain().back().reference_rad;
    EXPECT_NEAR(reference_rad[0], 0.05, 1e-12) << "0.5 rad/s for 100 ms";
    EXPECT_NEAR(reference_rad[1], -0.05, 1e-12);
    EXPECT_EQ(reference_rad[2], 0.0);
}

TEST_F(SimulatedArmDeviceTest, stopsAtTheEndOfAJointsRangeAndMovesBackOnly) {
    make();
    start();
    advance_ms(1);
    const auto jogElbow = [&](double rate_radPerS) {
        jog({0.0, 0.0, 0.0, rate_radPerS});
        advance_ms(90);
        double furthest_rad = 0.0;
        for (const core::JointSample& sample : drain())
            furthest_rad = std::max(furthest_rad, std::abs(sample.reference_rad[3]));
        return furthest_rad;
    };
    EXPECT_NEAR(jogElbow(0.5), 0.02, 1e-12) << "45 mrad were asked for";
    EXPECT_NEAR(jogElbow(0.5), 0.02, 1e-12);
    EXPECT_EQ(drive(), ArmDrive::jog) << "the operator still holds it";
    jogElbow(-0.05);
    jog({});
    advance_ms(1);
    EXPECT_NEAR(drain().back().reference_rad[3], 0.02 - 0.05 * 0.09, 1e-9);
    jogElbow(-0.5);
    jog({});
    advance_ms(1);
    EXPECT_NEAR(drain().back().reference_rad[3], -0.01, 1e-12);
}

TEST_F(SimulatedArmDeviceTest, doesNotTrustACommandFromTheFuture) {
    make();
    start();
    advance_ms(1);
    m_device->post({.rate_radPerS = {0.1, 0.0, 0.0, 0.0}, .time_ns = m_clock->now_ns() + 3600'000 * kMs_ns});
    advance_ms(100);
    EXPECT_EQ(drive(), ArmDrive::jog);
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::held);
    m_device->post({.rate_radPerS = {0.1, 0.0, 0.0, 0.0}, .time_ns = m_clock->now_ns() - 101 * kMs_ns});
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::held) << "nor an old one";
}

TEST_F(SimulatedArmDeviceTest, standsStillFromTheFirstStepAfterStop) {
    make();
    start();
    advance_ms(10);
    jog({0.1, 0.0, 0.0, 0.0});
    advance_ms(5);
    const double before_rad = drain().back().reference_rad[0];
    m_stop.engage();
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::stopped);
    jog({0.1, 0.0, 0.0, 0.0});
    m_device->setProgramRunning(true);
    m_device->restartProgram();
    advance_ms(20);
    for (const core::JointSample& sample : drain()) {
        EXPECT_EQ(driveOf(sample), ArmDrive::stopped);
        EXPECT_EQ(sample.reference_rad[0], before_rad);
        EXPECT_FALSE(sample.discontinuity);
    }
    m_stop.release();
    advance_ms(50);
    EXPECT_EQ(drive(), ArmDrive::held) << "nothing moves by itself when STOP is released";
    EXPECT_EQ(drain().back().reference_rad[0], before_rad);
    jog({0.1, 0.0, 0.0, 0.0});
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::jog);
}

TEST_F(SimulatedArmDeviceTest, countsWhatTheLinkDrops) {
    make({.queueBlocks = 1024, .faults = {.dropShare = 0.25}});
    start();
    advance_ms(4000);
    const auto samples = drain();
    const core::DeviceStatus status = m_device->status();
    EXPECT_EQ(status.framesRead, samples.size());
    EXPECT_EQ(status.framesRead + status.framesLost, 4000U);
    // Five standard deviations of a binomial with n = 4000, p = 1/4.
    EXPECT_NEAR(static_cast<double>(status.framesLost), 1000.0, 5.0 * std::sqrt(4000.0 * 0.25 * 0.75));
    const core::DeviceStatus skin = m_skin->status();
    EXPECT_EQ(skin.framesRead + skin.framesLost, 800U);
    EXPECT_GT(skin.framesLost, 0U);
}

TEST_F(SimulatedArmDeviceTest, goesStaleWhenNothingComesAndLiveWhenItDoes) {
    make({.staleAfter_s = 0.2});
    start();
    advance_ms(50);
    m_device->setFaults({.silent = true});
    m_clock->advance(199 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::live);
    m_clock->advance(1 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::stale);
    EXPECT_EQ(m_skin->status().state, DeviceState::stale);
    EXPECT_EQ(m_device->status().framesRead, 50U);
    m_device->setFaults({});
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        m_clock->advance(kMs_ns);
        return state() == DeviceState::live;
    }));
}

TEST_F(SimulatedArmDeviceTest, lagsBehindAtTheFullRate) {
    make({.faults = {.lag_s = 0.25}});
    start();
    advance_ms(250);
    EXPECT_TRUE(drain().empty());
    advance_ms(50);
    EXPECT_EQ(drain().size(), 50U);
    m_device->setFaults({.lag_s = std::nan("")});
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->status().framesRead == 300U; }))
        << "without the lag all that was late comes at once";
}

TEST_F(SimulatedArmDeviceTest, isHeldAfterItWasUnplugged) {
    make();
    start();
    advance_ms(50);
    drain();
    drainSkin();
    m_device->setFaults({.unplugged = true});
    ASSERT_TRUE(eventually(m_wakeup, [&] { return state() == DeviceState::lost; }));
    EXPECT_FALSE(m_device->status().message.empty());
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_skin->status().state == DeviceState::lost; }));
    m_clock->settle();
    m_clock->advance(100 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::reconnecting);
    m_device->setProgramRunning(true);
    m_device->setFaults({});
    m_clock->settle();
    m_clock->advance(2000 * kMs_ns);
    advance_ms(10);
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_EQ(drive(), ArmDrive::held);
    const auto samples = drain();
    ASSERT_FALSE(samples.empty());
    EXPECT_TRUE(samples[0].discontinuity);
    const auto frames = drainSkin();
    ASSERT_FALSE(frames.empty());
    EXPECT_TRUE(frames[0].discontinuity);
    m_device->setProgramRunning(true);
    advance_ms(1);
    EXPECT_EQ(drive(), ArmDrive::program);
}

TEST_F(SimulatedArmDeviceTest, endsInEveryState) {
    for (const SimulatedFaults& faults :
         {SimulatedFaults{}, SimulatedFaults{.silent = true}, SimulatedFaults{.unplugged = true}}) {
        make({.faults = faults});
        start();
        m_device->stop();
        EXPECT_EQ(state(), DeviceState::closed);
    }
    make();
    start();
    m_device.reset(); // the destructor stops
}

TEST_F(SimulatedArmDeviceTest, startsAnewAfterStop) {
    make();
    start();
    advance_ms(25);
    m_device->stop();
    drain();
    start();
    EXPECT_EQ(m_device->status().framesRead, 0U);
    advance_ms(5);
    const auto samples = drain();
    ASSERT_EQ(samples.size(), 5U);
    EXPECT_TRUE(samples[0].discontinuity);
}

// The real clock: a second of samples at 1 kHz arrives whole and in order.
TEST(SimulatedArmDevice, losesNoSampleInRealTime) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedArmDevice device(std::make_unique<CountingArm>(), stop);
    const std::int64_t begin_ns = core::steadyNow_ns();
    device.start(wakeup);
    std::vector<core::JointSample> samples;
    ASSERT_TRUE(eventually(wakeup, [&] {
        core::JointSample sample;
        while (device.joints().pop(sample))
            samples.push_back(sample);
        return samples.size() >= 1000;
    }));
    device.stop();
    std::int64_t last_ns = begin_ns;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(samples[i].angle_rad[0], static_cast<double>(i + 1));
        ASSERT_GE(samples[i].time_ns, last_ns);
        last_ns = samples[i].time_ns;
    }
    // Never early: sample k is due k periods after the start.
    EXPECT_GE(last_ns - begin_ns, static_cast<std::int64_t>(samples.size()) * kMs_ns);
    EXPECT_EQ(device.status().framesLost, 0U);
}

// A real scene: what the console runs.
TEST(SimulatedArmDevice, streamsTheArmOfASceneWithItsSkin) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/teleta-touch.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    auto generator = simulation::makeArm(*scene, 1);
    ASSERT_TRUE(generator) << describe(generator.error());
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedArmDevice device(std::move(*generator), stop);
    const auto skin = device.makeSkin();
    EXPECT_TRUE(device.description().hasProgram);
    device.start(wakeup);
    std::vector<core::JointSample> samples;
    std::size_t frames = 0;
    ASSERT_TRUE(eventually(wakeup, [&] {
        core::JointSample sample;
        while (device.joints().pop(sample))
            samples.push_back(sample);
        core::SampleBlock block;
        while (skin->blocks().pop(block)) {
            EXPECT_EQ(block.values.size(), skin->description().layout.taxels());
            frames += block.frames();
        }
        return samples.size() >= 500 && frames >= 100;
    }));
    EXPECT_EQ(device.drive(), ArmDrive::program);
    stop.engage();
    ASSERT_TRUE(eventually(wakeup, [&] { return device.drive() == ArmDrive::stopped; }));
    device.stop();
    for (std::size_t i = 1; i < samples.size(); ++i)
        ASSERT_NEAR(samples[i].sourceTime_s - samples[i - 1].sourceTime_s, 1e-3, 1e-9);
    EXPECT_EQ(device.status().framesLost, 0U);
    EXPECT_EQ(skin->status().framesLost, 0U);
}

TEST_F(SimulatedArmDeviceTest, takesAStopWhileItTellsNothingAndDoesNotGoOnByItselfAfterwards) {
    make({.startProgram = true});
    start();
    advance_ms(20);
    ASSERT_EQ(drive(), ArmDrive::program);
    m_device->setFaults({.silent = true});
    m_clock->settle();
    m_stop.engage();
    m_clock->advance(20 * kMs_ns);
    EXPECT_EQ(drive(), ArmDrive::stopped);
    m_stop.release();
    m_clock->advance(20 * kMs_ns);
    EXPECT_EQ(drive(), ArmDrive::held);
    m_device->setFaults({});
    m_clock->settle();
    advance_ms(20);
    EXPECT_EQ(drive(), ArmDrive::held) << "STOP was pressed meanwhile";
}
