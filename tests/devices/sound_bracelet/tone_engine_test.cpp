// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/steady_time.h"
#include "devices/sound_bracelet/tone_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <thread>
#include <vector>

namespace {

std::atomic<bool> countsAllocations{false};
std::atomic<int> allocations{0};

} // namespace

// Every form of new ends here. malloc itself is not watched: the engine calls no library of C.
void* operator new(std::size_t size) {
    if (countsAllocations.load(std::memory_order_relaxed))
        allocations.fetch_add(1, std::memory_order_relaxed);
    if (void* memory = std::malloc(size == 0 ? 1 : size))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace teleta::sound {
namespace {

constexpr double kRate_Hz = 48'000.0;
constexpr std::size_t kPeriod = 128;
constexpr std::int64_t kPeriod_ns = 2'666'667;
constexpr std::int64_t kTimeout_ns = 100'000'000;
constexpr core::Drive kFull{4095, 4095, 4095, 4095, 4095, 4095};

ToneEngine::Tones tones(double ramp_s = 0.002) {
    ToneEngine::Tones tones;
    tones.fill({.carrier_Hz = 250.0, .fullScale = 0.5, .ramp_s = ramp_s});
    return tones;
}

class ToneEngineTest : public testing::Test {
protected:
    /// The next period; all its samples of all tactors, one after the other.
    std::vector<float> period() {
        std::vector<float> samples(core::kTactors * kPeriod);
        ToneEngine::Outputs outputs;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            outputs[i] = std::span(samples).subspan(i * kPeriod, kPeriod);
        m_engine.render(outputs, m_now_ns);
        m_now_ns += kPeriod_ns;
        return samples;
    }
    /// Largest sample of the next periods.
    float loudest(int periods = 4) {
        float most = 0.0F;
        for (int i = 0; i < periods; ++i)
            for (const float sample : period())
                most = std::max(most, std::abs(sample));
        return most;
    }
    void set(const core::Drive& drive) {
        m_engine.set(
            {.drive = drive, .written_ns = m_now_ns, .timeout_ns = kTimeout_ns, .sequence = ++m_sequence});
    }
    /// The newest frame that the callback took.
    PlayedFrame newest() {
        PlayedFrame frame;
        while (m_engine.played(frame)) {
        }
        return frame;
    }

    core::StopSwitch m_stop;
    ToneEngine m_engine{tones(), kRate_Hz, m_stop};
    std::int64_t m_now_ns = 1'000'000'000;
    std::uint16_t m_sequence = 0;
};

} // namespace

TEST_F(ToneEngineTest, isSilentUntilAFrameComes) {
    EXPECT_EQ(loudest(), 0.0F);
    EXPECT_FALSE(m_engine.isAudible());
    PlayedFrame frame;
    EXPECT_FALSE(m_engine.played(frame));
}

TEST_F(ToneEngineTest, playsEachTactorAsStrongAsItsDrive) {
    set({0, 1024, 2048, 3072, 4095, 65'535});
    (void)period();
    std::array<float, core::kTactors> most{};
    for (int i = 0; i < 4; ++i) {
        const std::vector<float> samples = period();
        for (std::size_t k = 0; k < samples.size(); ++k)
            most[k / kPeriod] = std::max(most[k / kPeriod], samples[k]);
    }
    for (std::size_t i = 0; i < most.size(); ++i)
        EXPECT_NEAR(most[i], 0.5 * std::min(1.0, 1024.0 * static_cast<double>(i) / 4095.0), 2e-4) << i;
}

TEST_F(ToneEngineTest, reportsEachFrameThatItTook) {
    set({1, 0, 0, 0, 0, 0});
    const std::int64_t first_ns = m_now_ns;
    (void)period();
    (void)period();
    set({});
    (void)period();
    PlayedFrame frame;
    ASSERT_TRUE(m_engine.played(frame));
    EXPECT_EQ(frame.sequence, 1);
    EXPECT_EQ(frame.played_ns, first_ns);
    EXPECT_TRUE(frame.driving);
    EXPECT_FALSE(frame.timedOut);
    ASSERT_TRUE(m_engine.played(frame));
    EXPECT_EQ(frame.sequence, 2);
    EXPECT_EQ(frame.played_ns, first_ns + 2 * kPeriod_ns);
    EXPECT_FALSE(frame.driving);
    EXPECT_FALSE(m_engine.played(frame)) << "a frame is reported once";
    // One that was replaced before a callback took it was never played.
    set(kFull);
    set(kFull);
    (void)period();
    ASSERT_TRUE(m_engine.played(frame));
    EXPECT_EQ(frame.sequence, 4);
    EXPECT_FALSE(m_engine.played(frame));
}

TEST_F(ToneEngineTest, goesToZeroWithin5MsWhenNoFrameComes) {
    set(kFull);
    const std::int64_t end_ns = m_now_ns + kTimeout_ns;
    while (m_now_ns <= end_ns)
        EXPECT_GT(loudest(1), 0.1F);
    // The callback that finds it late ramps down: 5 ms are two periods.
    (void)period();
    (void)period();
    EXPECT_EQ(loudest(), 0.0F);
    EXPECT_FALSE(m_engine.isAudible());
    (void)newest();
    set(kFull);
    (void)period();
    const PlayedFrame frame = newest();
    EXPECT_TRUE(frame.timedOut) << "since the last frame";
    EXPECT_TRUE(frame.driving);
    EXPECT_GT(loudest(), 0.4F);
    set(kFull);
    (void)period();
    EXPECT_FALSE(newest().timedOut);
}

TEST_F(ToneEngineTest, takesAFrameThatIsTooOldAsNone) {
    m_engine.set({.drive = kFull, .written_ns = m_now_ns - kTimeout_ns - 1, .timeout_ns = kTimeout_ns});
    EXPECT_EQ(loudest(), 0.0F);
    const PlayedFrame frame = newest();
    EXPECT_TRUE(frame.timedOut);
    EXPECT_FALSE(frame.driving);
}

TEST_F(ToneEngineTest, rampsDownInTimeAlsoWhereItsOwnRampIsLonger) {
    ToneEngine slow(tones(0.02), kRate_Hz, m_stop);
    std::vector<float> samples(core::kTactors * kPeriod);
    ToneEngine::Outputs outputs;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        outputs[i] = std::span(samples).subspan(i * kPeriod, kPeriod);
    slow.set({.drive = kFull, .written_ns = m_now_ns, .timeout_ns = kTimeout_ns});
    for (int i = 0; i < 20; ++i)
        slow.render(outputs, m_now_ns);
    m_stop.engage();
    slow.render(outputs, m_now_ns);
    slow.render(outputs, m_now_ns);
    slow.render(outputs, m_now_ns);
    EXPECT_TRUE(std::ranges::all_of(samples, [](float sample) { return sample == 0.0F; }));
}

TEST_F(ToneEngineTest, obeysStopInEveryCallback) {
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
    m_stop.engage();
    (void)period();
    (void)period();
    EXPECT_EQ(loudest(), 0.0F);
    // A frame while STOP is engaged drives nothing, and nothing resumes by itself afterwards.
    set(kFull);
    EXPECT_EQ(loudest(), 0.0F);
    EXPECT_FALSE(newest().driving);
    m_stop.release();
    EXPECT_EQ(loudest(), 0.0F);
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
}

TEST_F(ToneEngineTest, noticesAStopThatWasReleasedBetweenTwoCallbacks) {
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
    m_stop.engage();
    m_stop.release();
    (void)period();
    (void)period();
    EXPECT_EQ(loudest(), 0.0F);
    set(kFull);
    m_stop.engage();
    m_stop.release();
    EXPECT_EQ(loudest(), 0.0F) << "a frame from before it counts no more";
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
}

TEST_F(ToneEngineTest, isSilentAtOnceAndForGoodAfterAFault) {
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
    m_engine.fail(SoundFault::rateChanged);
    EXPECT_EQ(loudest(), 0.0F);
    set(kFull);
    EXPECT_EQ(loudest(), 0.0F);
    PlayedFrame frame;
    (void)newest();
    set(kFull);
    (void)period();
    EXPECT_FALSE(m_engine.played(frame)) << "it is not confirmed either";
    m_engine.fail(SoundFault::serverGone);
    EXPECT_EQ(m_engine.fault(), SoundFault::rateChanged) << "the first one is the cause";
}

TEST_F(ToneEngineTest, countsAMissedPeriodAndEndsWhereATactorWasDriven) {
    (void)period();
    m_engine.missPeriod();
    EXPECT_EQ(m_engine.fault(), SoundFault::none);
    set(kFull);
    EXPECT_GT(loudest(), 0.4F);
    m_engine.missPeriod();
    EXPECT_EQ(m_engine.fault(), SoundFault::missedPeriod);
    EXPECT_EQ(m_engine.cost().missedPeriods, 2U);
    EXPECT_EQ(loudest(), 0.0F);
}

TEST_F(ToneEngineTest, measuresWhatItsCallbackCosts) {
    EXPECT_EQ(m_engine.cost().meanShare, 0.0);
    m_now_ns = core::steadyNow_ns() - 1'333'333;
    (void)period();
    const CallbackCost cost = m_engine.cost();
    EXPECT_EQ(cost.callbacks, 1U);
    EXPECT_GE(cost.meanShare, 0.5) << "it began half a period ago";
    EXPECT_GE(cost.longestShare, cost.meanShare);
}

TEST_F(ToneEngineTest, allocatesNothingInTheCallback) {
    std::vector<float> samples(core::kTactors * kPeriod);
    ToneEngine::Outputs outputs;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        outputs[i] = std::span(samples).subspan(i * kPeriod, kPeriod);
    countsAllocations = true;
    for (int i = 0; i < 1000; ++i) {
        set(i % 3 == 0 ? kFull : core::Drive{});
        m_engine.render(outputs, m_now_ns);
        if (i == 700)
            m_stop.engage();
        if (i == 800)
            m_stop.release();
        if (i == 900)
            m_engine.fail(SoundFault::deviceGone);
    }
    countsAllocations = false;
    EXPECT_EQ(allocations.load(), 0) << "although nobody reads the reports, whose queue is full";
    std::vector<int>* const counted = [] {
        countsAllocations = true;
        auto* numbers = new std::vector<int>(3);
        countsAllocations = false;
        return numbers;
    }();
    EXPECT_GT(allocations.load(), 0) << "the count works";
    delete counted;
}

TEST_F(ToneEngineTest, takesWholeFramesFromAnotherThread) {
    std::atomic<bool> ends{false};
    std::jthread writer([&] {
        for (std::uint16_t k = 1; !ends; ++k) {
            core::Drive drive;
            drive.fill(static_cast<std::uint16_t>(k % 4096));
            m_engine.set(
                {.drive = drive, .written_ns = 1, .timeout_ns = std::int64_t{1} << 60, .sequence = k});
            PlayedFrame frame;
            while (m_engine.played(frame)) {
            }
        }
    });
    for (int i = 0; i < 2000; ++i) {
        const std::vector<float> samples = period();
        for (std::size_t k = kPeriod; k < samples.size(); ++k)
            ASSERT_EQ(samples[k], samples[k % kPeriod]) << "all tactors are of the same frame";
    }
    ends = true;
}

} // namespace teleta::sound
