// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/simulated/counting_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

using namespace teleta;
using core::DeviceState;
using simulated::SimulatedArmConfig;
using simulated::SimulatedArmDevice;
using test::CountingArm;

namespace {

/// The same arm at another place: what it tells takes so many steps, and every tenth message is lost.
class DistantArm : public CountingArm {
public:
    explicit DistantArm(int delaySteps)
        : m_delay_s(1e-3 * delaySteps) {}

    void next(const core::ArmDemand& demand, core::JointSample& sample) override {
        CountingArm::next(demand, sample);
        m_told.push_back(sample);
    }
    bool skinFrame(std::span<float>) override { return false; }
    [[nodiscard]] bool isRemote() const override { return true; }
    bool takeArrival(core::ArmArrival& arrival) override {
        while (m_taken < m_told.size() && m_told[m_taken].sourceTime_s < time_s() - m_delay_s + 0.0005) {
            arrival.sample = m_told[m_taken++];
            arrival.hasFrame = m_taken % 5 == 1;
            arrival.frame = {1.0F, 2.0F};
            if (m_taken % 10 != 0)
                return true;
            ++m_lost;
        }
        return false;
    }
    [[nodiscard]] core::ArmLinkCounters linkCounters() const override { return {.samplesLost = m_lost}; }

private:
    double m_delay_s;
    std::vector<core::JointSample> m_told;
    std::size_t m_taken = 0;
    std::uint64_t m_lost = 0;
};

class DistantArmDeviceTest : public test::SimulatedArmDeviceTest {
protected:
    void startDistant(int delay_ms) {
        m_device = std::make_unique<SimulatedArmDevice>(std::make_unique<DistantArm>(delay_ms), m_stop,
                                                        SimulatedArmConfig{.clock = m_clock});
        m_skin = m_device->makeSkin();
        start();
    }
};

} // namespace

TEST_F(DistantArmDeviceTest, stampsWhatComesWithTheTimeAtWhichItWasReadThere) {
    startDistant(20);
    const std::int64_t begin_ns = m_clock->now_ns();
    advance_ms(120);
    const auto samples = drain();
    ASSERT_EQ(samples.size(), 90U); // of a hundred that were sent long enough ago
    for (const core::JointSample& sample : samples)
        EXPECT_EQ(sample.time_ns - begin_ns, std::llround(1e9 * sample.sourceTime_s));
    const core::DeviceStatus status = m_device->status();
    EXPECT_EQ(status.framesLost, 10U);
    EXPECT_EQ(status.lastData_ns, m_clock->now_ns() - 1'000'000) << "late is not stale; one was lost";
}

TEST_F(DistantArmDeviceTest, itsSkinIsLiveAllTheSame) {
    constexpr int kDelay_ms = 250; // more than a skin may be silent
    startDistant(kDelay_ms);
    const std::int64_t begin_ns = m_clock->now_ns();
    advance_ms(kDelay_ms + 5);
    const core::DeviceStatus first = m_skin->status();
    ASSERT_EQ(first.state, DeviceState::live);
    for (int ms = 0; ms < 150; ++ms) {
        advance_ms(1);
        ASSERT_EQ(m_skin->status().state, DeviceState::live) << ms;
        ASSERT_EQ(m_skin->status().since_ns, first.since_ns) << "not stale in between, " << ms;
    }
    EXPECT_NEAR(m_skin->status().rate_Hz, 200.0, 2.0);
    const auto blocks = drainSkin();
    ASSERT_GE(blocks.size(), 29U);
    for (const core::SampleBlock& block : blocks)
        EXPECT_EQ(block.time_ns.front() - begin_ns, std::llround(1e9 * block.sourceTime_s.front()));
}
