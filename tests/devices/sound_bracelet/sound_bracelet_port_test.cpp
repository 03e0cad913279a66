// SPDX-License-Identifier: GPL-3.0-or-later
// The port with an output that the test plays itself: each call of play() is a callback.
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/playback/safety_limiter.h"
#include "devices/sound_bracelet/sound_bracelet_port.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

namespace teleta::sound {
namespace {

struct Card {
    ToneEngine* engine = nullptr;
    bool disconnected = false;
    bool closed = false;

    float play(std::int64_t now_ns = core::steadyNow_ns(), std::size_t frames = 128) {
        std::vector<float> samples(core::kTactors * frames);
        ToneEngine::Outputs outputs;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            outputs[i] = std::span(samples).subspan(i * frames, frames);
        engine->render(outputs, now_ns);
        float most = 0.0F;
        for (const float sample : samples)
            most = std::max(most, std::abs(sample));
        return most;
    }
};

class PlayedOutput : public SoundOutput {
public:
    explicit PlayedOutput(Card& card)
        : m_card(card) {}
    ~PlayedOutput() override { m_card.closed = true; }
    void check() override {
        if (m_card.disconnected)
            m_card.engine->fail(SoundFault::disconnected);
    }
    [[nodiscard]] std::string where() const override { return "a card that the test plays"; }
    [[nodiscard]] double statedLatency_s() const override { return 0.008; }

private:
    Card& m_card;
};

class SoundBraceletPortTest : public testing::Test {
protected:
    core::OpenedBracelet open() {
        auto opened =
            openSoundBraceletPort(m_file, m_stop, [this](const SoundBraceletFile&, ToneEngine& engine) {
                m_card.engine = &engine;
                m_card.play();
                return core::Expected<std::unique_ptr<SoundOutput>>(std::make_unique<PlayedOutput>(m_card));
            });
        EXPECT_TRUE(opened);
        return std::move(*opened);
    }

    SoundBraceletPortTest() {
        m_file.name = "voice coils";
        m_file.device = "pipewire:tactors";
    }

    SoundBraceletFile m_file;
    core::StopSwitch m_stop;
    Card m_card;
    core::BoardReport m_report;
};

constexpr core::Drive kFull{4095, 4095, 4095, 4095, 4095, 4095};

} // namespace

TEST_F(SoundBraceletPortTest, saysWhatItIs) {
    const auto opened = open();
    EXPECT_EQ(opened.description.name, "voice coils");
    EXPECT_EQ(opened.description.serial, "pipewire:tactors#1-2-3-4-5-6");
    EXPECT_EQ(opened.description.model, "a card that the test plays");
    EXPECT_EQ(opened.description.statedLatency_s, 0.008);
    EXPECT_EQ(opened.description.maximumRate_Hz, 200.0);
    EXPECT_FALSE(opened.description.simulated);
}

TEST_F(SoundBraceletPortTest, knowsWhenAFrameIsFeltOnlyWhereThatWasMeasured) {
    EXPECT_TRUE(std::isnan(open().description.measuredLatency_s));
    EXPECT_EQ(open().description.feltAt_ns(1'000'000'000), 1'000'000'000);
    m_file.latency_ms = 7.5;
    m_file.latencySpread_ms = 1.25;
    const auto opened = open();
    EXPECT_DOUBLE_EQ(opened.description.measuredLatency_s, 0.0075);
    EXPECT_DOUBLE_EQ(opened.description.latencySpread_s, 0.00125);
    EXPECT_EQ(opened.description.feltAt_ns(1'000'000'000), 1'007'500'000);
}

TEST_F(SoundBraceletPortTest, takesNoMoreFramesThanTheCardPeriods) {
    m_file.period_frames = 1024;
    EXPECT_DOUBLE_EQ(open().description.maximumRate_Hz, 46.875);
}

TEST_F(SoundBraceletPortTest, saysWhyTheCardCannotBeOpened) {
    const auto failed = openSoundBraceletPort(m_file, m_stop, [](const SoundBraceletFile&, ToneEngine&) {
        return core::Expected<std::unique_ptr<SoundOutput>>(
            core::failed(core::ErrorKind::unavailable, QStringLiteral("no card")));
    });
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().message, "no card");
}

TEST_F(SoundBraceletPortTest, confirmsAFrameWhenTheCallbackTookIt) {
    const auto opened = open();
    EXPECT_TRUE(opened.port->write(7, kFull, 100));
    EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::nothing) << "nobody played it yet";
    const std::int64_t now_ns = core::steadyNow_ns();
    m_card.play(now_ns);
    EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::report);
    EXPECT_EQ(m_report.sequence, 7);
    EXPECT_TRUE(m_report.driving);
    EXPECT_FALSE(m_report.tooHot || m_report.supplyLow || m_report.frameRefused || m_report.timedOut);
    EXPECT_TRUE(std::isnan(m_report.supply_V)) << "a sound card does not know";
    EXPECT_TRUE(std::isnan(m_report.temperature_degC));
    ASSERT_TRUE(m_report.sound);
    EXPECT_EQ(m_report.sound->played_ns, now_ns);
    EXPECT_GT(m_report.sound->meanShare, 0.0);
    EXPECT_EQ(m_report.sound->missedPeriods, 0U);
    EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::nothing);
    EXPECT_GT(m_card.play(), 0.4F);
}

TEST_F(SoundBraceletPortTest, isLostAfterAFaultAndSaysWhy) {
    for (const SoundFault fault :
         {SoundFault::missedPeriod, SoundFault::serverGone, SoundFault::deviceGone, SoundFault::rateChanged,
          SoundFault::periodChanged, SoundFault::disconnected, SoundFault::sharedWithOthers,
          SoundFault::callbacksStopped}) {
        const auto opened = open();
        EXPECT_TRUE(opened.port->write(1, kFull, 100));
        m_card.play();
        EXPECT_GT(m_card.play(), 0.4F);
        m_card.engine->fail(fault);
        EXPECT_EQ(m_card.play(), 0.0F) << "zeros first";
        EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::lost);
        EXPECT_FALSE(opened.port->write(2, kFull, 100));
        EXPECT_EQ(opened.port->failure(), describe(fault));
        EXPECT_FALSE(opened.port->failure().empty());
    }
}

TEST_F(SoundBraceletPortTest, isLostWhenATactorIsDisconnected) {
    const auto opened = open();
    m_card.disconnected = true;
    EXPECT_FALSE(opened.port->write(1, kFull, 100));
    EXPECT_EQ(opened.port->failure(), describe(SoundFault::disconnected));
    EXPECT_EQ(m_card.play(), 0.0F);
}

TEST_F(SoundBraceletPortTest, isLostWhenNobodyAsksForSamples) {
    const auto opened = open();
    m_card.play(core::steadyNow_ns() - 400'000'000);
    EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::nothing);
    m_card.play(core::steadyNow_ns() - 600'000'000);
    EXPECT_EQ(opened.port->read(m_report), core::BraceletPort::Read::lost);
    EXPECT_EQ(opened.port->failure(), describe(SoundFault::callbacksStopped));
}

TEST_F(SoundBraceletPortTest, closesTheCardAfterTheRampOfAZeroFrame) {
    auto opened = open();
    EXPECT_TRUE(opened.port->write(1, kFull, 100));
    m_card.play();
    EXPECT_GT(m_card.play(), 0.4F);
    EXPECT_TRUE(opened.port->write(2, {}, 100));
    std::jthread callbacks([this](const std::stop_token& stop) {
        for (int i = 0; i < 3 && !stop.stop_requested(); ++i)
            m_card.play();
    });
    callbacks.join();
    EXPECT_FALSE(m_card.engine->isAudible());
    opened.port.reset();
    EXPECT_TRUE(m_card.closed);
}

// Full intensity for as long as the motors' limits allow: sqrt(1/2) of it in the long run.
TEST_F(SoundBraceletPortTest, isHeldAtTheHeatBudgetLikeAMotor) {
    const auto opened = open();
    playback::SafetyLimiter limiter({}, 0.005);
    const core::Intensities full{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    const auto playFor = [&](int frames) {
        float most = 0.0F;
        for (int i = 0; i < frames; ++i) {
            EXPECT_TRUE(opened.port->write(static_cast<std::uint16_t>(i), limiter.step(full, 0.005), 100));
            most = std::max(most, m_card.play(core::steadyNow_ns(), 240));
        }
        return most;
    };
    EXPECT_NEAR(playFor(200), 0.5F, 1e-3F) << "at first at full scale";
    playFor(12'000);
    EXPECT_NEAR(playFor(200), 0.5F * static_cast<float>(std::numbers::sqrt2) / 2.0F, 2e-3F);
}

} // namespace teleta::sound
