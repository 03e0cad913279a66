// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"
#include "devices/simulated/simulated_array_device.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace teleta;
using core::DeviceState;
using simulated::SimulatedArrayConfig;
using simulated::SimulatedArrayDevice;
using simulated::SimulatedFaults;
using test::eventually;
using test::ManualClock;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;

/// Frames whose first taxel counts the frames and whose second one counts those with motion.
class CountingGenerator : public core::FrameGenerator {
public:
    explicit CountingGenerator(double rate_Hz)
        : m_rate_Hz(rate_Hz) {}

    [[nodiscard]] core::SourceDescription description() const override {
        return {.name = "counter",
                .layout = core::ArrayLayout{1, 2, 0.01},
                .unit = "N",
                .nominalRate_Hz = m_rate_Hz,
                .simulated = true};
    }
    void next(std::span<float> values, bool motionHeld) override {
        ++m_frames;
        if (!motionHeld)
            ++m_moved;
        values[0] = static_cast<float>(m_frames);
        values[1] = static_cast<float>(m_moved);
    }
    [[nodiscard]] double time_s() const override { return m_frames / m_rate_Hz; }
    void restart() override { m_frames = m_moved = 0; }

private:
    double m_rate_Hz;
    int m_frames = 0;
    int m_moved = 0;
};

class SimulatedArrayDeviceTest : public testing::Test {
protected:
    void make(SimulatedArrayConfig config = {}, double rate_Hz = 200.0) {
        config.clock = m_clock;
        m_device = std::make_unique<SimulatedArrayDevice>(std::make_unique<CountingGenerator>(rate_Hz),
                                                          m_stop, std::move(config));
    }

    void start() {
        m_device->start(m_wakeup);
        m_clock->settle();
    }

    /// Moves the clock in steps of a sample period of 200 Hz.
    void advance_ms(int duration_ms) {
        for (int i = 0; i < duration_ms; i += 5)
            m_clock->advance(5 * kMs_ns);
    }

    std::vector<core::SampleBlock> drain() {
        std::vector<core::SampleBlock> blocks;
        core::SampleBlock block;
        while (m_device->blocks().pop(block))
            blocks.push_back(std::move(block));
        return blocks;
    }

    [[nodiscard]] DeviceState state() const { return m_device->status().state; }

    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<SimulatedArrayDevice> m_device;
};

} // namespace

TEST_F(SimulatedArrayDeviceTest, isClosedConnectingLiveAndClosedAgain) {
    make();
    EXPECT_EQ(state(), DeviceState::closed);
    start();
    EXPECT_EQ(state(), DeviceState::connecting);
    EXPECT_EQ(m_device->status().lastData_ns, 0);
    m_clock->advance(5 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_EQ(m_device->status().lastData_ns, m_clock->now_ns());
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
    m_device->stop();
    EXPECT_EQ(m_device->playback(), nullptr);
    EXPECT_TRUE(m_device->description().simulated);
}

TEST_F(SimulatedArrayDeviceTest, deliversEveryFrameWhenItIsDueAndStampsIt) {
    make();
    const std::int64_t begin_ns = m_clock->now_ns();
    start();
    m_clock->advance(5 * kMs_ns - 1);
    EXPECT_TRUE(drain().empty());
    m_clock->advance(1);
    advance_ms(495);
    const std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 100U);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const core::SampleBlock& block = blocks[i];
        ASSERT_EQ(block.frames(), 1U);
        EXPECT_EQ(block.channels, 2U);
        EXPECT_EQ(block.firstFrame, i);
        EXPECT_EQ(block.time_ns[0], begin_ns + static_cast<std::int64_t>(i + 1) * 5 * kMs_ns);
        EXPECT_DOUBLE_EQ(block.sourceTime_s[0], static_cast<double>(i + 1) / 200.0);
        EXPECT_EQ(block.frame(0)[0], static_cast<float>(i + 1));
        EXPECT_FALSE(block.discontinuity);
    }
    const core::DeviceStatus status = m_device->status();
    EXPECT_EQ(status.framesRead, 100U);
    EXPECT_EQ(status.framesLost, 0U);
    EXPECT_NEAR(status.rate_Hz, 200.0, 1e-6);
}

TEST_F(SimulatedArrayDeviceTest, aSceneIsHeldAndBegunAnewWithoutASourceOfItsOwn) {
    auto scene = std::make_shared<core::SceneControl>();
    make({.scene = scene});
    start();
    advance_ms(20);
    scene->setRunning(false);
    advance_ms(20);
    std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 8U);
    EXPECT_EQ(blocks.back().frame(0)[0], 8.0F);
    EXPECT_EQ(blocks.back().frame(0)[1], 4.0F);
    m_stop.engage();
    scene->restart();
    advance_ms(5);
    m_stop.release();
    advance_ms(5);
    blocks = drain();
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_FALSE(blocks.back().discontinuity) << "what was asked under STOP is forgotten";
    EXPECT_EQ(blocks.back().frame(0)[0], 10.0F);
    scene->setRunning(false);
    scene->restart();
    advance_ms(10);
    blocks = drain();
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_TRUE(blocks[0].discontinuity);
    EXPECT_FALSE(blocks[1].discontinuity);
    EXPECT_DOUBLE_EQ(blocks[0].sourceTime_s[0], 1.0 / 200.0);
    EXPECT_EQ(blocks[1].frame(0)[1], 2.0F) << "one that was held runs from its beginning";
}

TEST_F(SimulatedArrayDeviceTest, keepsItsRateWhenItWakesLate) {
    make();
    start();
    m_clock->advance(503 * kMs_ns);
    std::size_t frames = 0;
    for (const core::SampleBlock& block : drain())
        frames += block.frames();
    EXPECT_EQ(frames, 100U) << "frames that were due meanwhile come in larger blocks";
    m_clock->advance(2 * kMs_ns);
    EXPECT_EQ(drain().size(), 1U) << "the next one is not delayed";
}

TEST_F(SimulatedArrayDeviceTest, doesNotCatchUpALongStandstill) {
    make({.longestCatchUp_s = 0.1});
    start();
    m_clock->advance(3600'000 * kMs_ns);
    EXPECT_EQ(m_device->status().framesRead, 1U);
    advance_ms(100);
    EXPECT_EQ(m_device->status().framesRead, 21U);
    EXPECT_EQ(m_device->status().framesLost, 0U);
}

TEST_F(SimulatedArrayDeviceTest, holdsTheMotionWhileStopIsEngaged) {
    make();
    start();
    advance_ms(50);
    m_stop.engage();
    advance_ms(50);
    m_stop.release();
    advance_ms(50);
    const std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 30U);
    EXPECT_EQ(blocks[9].frame(0)[1], 10.0F);
    EXPECT_EQ(blocks[19].frame(0)[1], 10.0F);
    EXPECT_EQ(blocks[29].frame(0)[0], 30.0F);
    EXPECT_EQ(blocks[29].frame(0)[1], 20.0F);
}

TEST_F(SimulatedArrayDeviceTest, aSceneThatStopHeldGoesOnOnlyWhenItIsAsked) {
    auto scene = std::make_shared<core::SceneControl>();
    make({.scene = scene});
    start();
    advance_ms(20);
    m_stop.engage();
    scene->setRunning(true); // is forgotten under STOP
    advance_ms(20);
    m_stop.release();
    advance_ms(20);
    EXPECT_TRUE(scene->isHeld());
    EXPECT_EQ(drain().back().frame(0)[1], 4.0F);
    scene->setRunning(true);
    advance_ms(20);
    EXPECT_EQ(drain().back().frame(0)[1], 8.0F);
    m_stop.engage();
    m_stop.release(); // before the next frame
    advance_ms(20);
    EXPECT_EQ(drain().back().frame(0)[1], 8.0F);
    EXPECT_TRUE(scene->isHeld());
}

TEST_F(SimulatedArrayDeviceTest, aSceneThatIsOpenedUnderStopDoesNotBeginWithItsRelease) {
    auto scene = std::make_shared<core::SceneControl>();
    m_stop.engage();
    make({.scene = scene});
    m_stop.release();
    start();
    advance_ms(20);
    EXPECT_EQ(drain().back().frame(0)[1], 0.0F);
    scene->setRunning(true);
    advance_ms(20);
    EXPECT_EQ(drain().back().frame(0)[1], 4.0F);
}

TEST_F(SimulatedArrayDeviceTest, countsWhatAFullQueueLoses) {
    make({.queueBlocks = 4});
    start();
    advance_ms(50);
    EXPECT_EQ(m_device->status().framesRead, 10U);
    EXPECT_EQ(m_device->status().framesLost, 6U);
    EXPECT_EQ(drain().size(), 4U);
    advance_ms(5);
    const std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_EQ(blocks[0].firstFrame, 10U) << "the gap in the numbers is the loss";
}

TEST_F(SimulatedArrayDeviceTest, countsWhatTheLinkDrops) {
    make({.faults = {.dropShare = 0.25}});
    start();
    advance_ms(5000);
    std::uint64_t received = 0;
    std::uint64_t missing = 0;
    std::uint64_t expected = 0;
    for (const core::SampleBlock& block : drain()) {
        missing += block.firstFrame - expected;
        expected = block.firstFrame + block.frames();
        received += block.frames();
        EXPECT_EQ(block.frame(0)[0], static_cast<float>(block.firstFrame + 1));
    }
    // The queue holds the first 256 of them.
    EXPECT_EQ(received, 256U);
    const core::DeviceStatus status = m_device->status();
    const std::uint64_t overflow = m_device->blocks().overflow();
    EXPECT_EQ(status.framesRead + status.framesLost - overflow, 1000U);
    // Five standard deviations of a binomial with n = 1000, p = 1/4.
    EXPECT_NEAR(static_cast<double>(status.framesLost - overflow), 250.0,
                5.0 * std::sqrt(1000.0 * 0.25 * 0.75));
    EXPECT_GT(missing, 0U);
}

TEST_F(SimulatedArrayDeviceTest, goesStaleWhenNothingComesAndLiveWhenItDoes) {
    make({.staleAfter_s = 0.2});
    start();
    advance_ms(50);
    const std::int64_t last_ns = m_clock->now_ns();
    m_device->setFaults({.silent = true});
    m_clock->advance(199 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::live);
    m_clock->advance(1 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::stale);
    EXPECT_EQ(m_device->status().lastData_ns, last_ns);
    EXPECT_EQ(m_device->status().since_ns, last_ns + 200 * kMs_ns);
    EXPECT_EQ(m_device->status().rate_Hz, 0.0);
    m_device->setFaults({});
    // The schedule begins anew when the worker sees the change: it is live one period later.
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        m_clock->advance(5 * kMs_ns);
        return state() == DeviceState::live;
    }));
    EXPECT_FALSE(drain().back().discontinuity);
}

TEST_F(SimulatedArrayDeviceTest, goesStaleWhenEveryFrameIsDropped) {
    make({.staleAfter_s = 0.1});
    start();
    advance_ms(50);
    m_device->setFaults({.dropShare = 1.0});
    m_clock->settle();
    advance_ms(200);
    EXPECT_EQ(state(), DeviceState::stale);
    EXPECT_GE(m_device->status().framesLost, 39U);
}

TEST_F(SimulatedArrayDeviceTest, staysConnectingWhileNoFrameEverCame) {
    make({.faults = {.silent = true}});
    start();
    m_clock->advance(10'000 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::connecting);
}

TEST_F(SimulatedArrayDeviceTest, lagsBehindAndCatchesUp) {
    make({.faults = {.lag_s = 0.25}});
    start();
    advance_ms(250);
    EXPECT_EQ(m_device->status().framesRead, 0U);
    advance_ms(50);
    EXPECT_EQ(m_device->status().framesRead, 10U) << "late by 250 ms, at the full rate";
    m_device->setFaults({});
    ASSERT_TRUE(eventually(m_wakeup, [&] { return m_device->status().framesRead == 60U; }))
        << "without the lag all that was late comes at once";
    EXPECT_EQ(m_device->status().framesLost, 0U);
}

TEST_F(SimulatedArrayDeviceTest, isLostWhenUnpluggedAndComesBackWhenPluggedIn) {
    make();
    start();
    advance_ms(50);
    drain();
    m_device->setFaults({.unplugged = true});
    ASSERT_TRUE(eventually(m_wakeup, [&] { return state() == DeviceState::lost; }));
    EXPECT_FALSE(m_device->status().message.empty());
    m_clock->settle();
    m_clock->advance(99 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::lost);
    m_clock->advance(1 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::reconnecting);
    m_clock->advance(5000 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::reconnecting);
    EXPECT_FALSE(m_device->status().message.empty());
    EXPECT_TRUE(drain().empty());

    m_device->setFaults({});
    m_clock->settle();
    m_clock->advance(2000 * kMs_ns);
    ASSERT_EQ(state(), DeviceState::connecting) << "within the longest time between two attempts";
    EXPECT_TRUE(m_device->status().message.empty());
    advance_ms(10);
    EXPECT_EQ(state(), DeviceState::live);
    const std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_TRUE(blocks[0].discontinuity);
    EXPECT_FALSE(blocks[1].discontinuity);
    EXPECT_EQ(blocks[0].firstFrame, 10U);
}

TEST_F(SimulatedArrayDeviceTest, stopsAtOnceInEveryState) {
    make({}, 1e-3);
    start(); // the next frame is due in 1000 s
    m_device->stop();
    EXPECT_EQ(state(), DeviceState::closed);
    for (const SimulatedFaults& faults :
         {SimulatedFaults{.silent = true}, SimulatedFaults{.unplugged = true}}) {
        make({.faults = faults});
        start();
        m_device->stop();
        EXPECT_EQ(state(), DeviceState::closed);
    }
    make();
    start();
    m_device.reset(); // the destructor stops
}

TEST_F(SimulatedArrayDeviceTest, startsAnewAfterStop) {
    make();
    start();
    advance_ms(25);
    m_device->stop();
    drain();
    start();
    EXPECT_EQ(m_device->status().framesRead, 0U);
    advance_ms(5);
    const std::vector<core::SampleBlock> blocks = drain();
    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_EQ(blocks[0].firstFrame, 0U);
    EXPECT_TRUE(blocks[0].discontinuity);
}

TEST_F(SimulatedArrayDeviceTest, ignoresALagThatIsNoNumber) {
    make({.faults = {.lag_s = std::nan("")}});
    start();
    advance_ms(5);
    EXPECT_EQ(m_device->status().framesRead, 1U);
}

// The real clock and a real scene: what the console runs.
TEST(SimulatedArrayDevice, streamsASceneInRealTime) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/tactile-indenter.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    auto generator = simulation::makeTactileArray(*scene, 1);
    ASSERT_TRUE(generator);
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedArrayDevice device(std::move(*generator), stop);
    const std::int64_t begin_ns = core::steadyNow_ns();
    device.start(wakeup);
    std::vector<core::SampleBlock> blocks;
    std::size_t frames = 0;
    ASSERT_TRUE(eventually(wakeup, [&] {
        core::SampleBlock block;
        while (device.blocks().pop(block)) {
            frames += block.frames();
            blocks.push_back(std::move(block));
        }
        return frames >= 20;
    }));
    device.stop();
    std::int64_t last_ns = begin_ns;
    for (const core::SampleBlock& block : blocks) {
        EXPECT_EQ(block.values.size(), block.frames() * 84);
        for (const std::int64_t time_ns : block.time_ns) {
            EXPECT_GE(time_ns, last_ns);
            last_ns = time_ns;
        }
    }
    // Never early: frame k is due k periods after the start.
    EXPECT_GE(blocks.back().time_ns.back() - begin_ns, static_cast<std::int64_t>(frames) * 5 * kMs_ns);
    EXPECT_LE(last_ns, core::steadyNow_ns());
}
