// SPDX-License-Identifier: GPL-3.0-or-later
// The temperatures of an array's chips are played with its frames.
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/stream_columns.h"
#include "devices/replay/recorded_device.h"
#include "tests/backend/recording/recorded_files.h"
#include "tests/devices/manual_clock.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

constexpr std::int64_t kStart_ns = 5'000'000'000;
constexpr std::int64_t kPeriod_ns = 10'000'000;

/// A recording of an array at 100 Hz, and of two chips with each fifth of its frames: the first is as warm as
/// the number of the frame says.
class RecordedTemperatures : public testing::Test {
protected:
    RecordedTemperatures() { makeApplication(); }

    void write(int frames, const std::string& name = "skin-temperatures",
               const pipeline::ChannelSettings& settings = {}) {
        auto recorder = Recorder::start(path(), headAt(kStart_ns), {.simulatedTime = true}).value();
        core::SourceDescription skin;
        skin.layout = core::ArrayLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
        const auto array = recorder->addStream(pipeline::arrayStream("skin-frames", skin, settings));
        const auto warm = recorder->addStream(pipeline::numberStream(name, skin, temperatureColumns(2)));
        for (int i = 0; i < frames; ++i) {
            const std::int64_t time_ns = kStart_ns + i * kPeriod_ns;
            appendFrame(*array, time_ns, static_cast<float>(i));
            const std::array<double, 2> values{static_cast<double>(i), 20.25};
            if (i % 5 == 0)
                warm->append(time_ns, 0.0, std::span<const double>(values));
        }
        ASSERT_TRUE(recorder->stop());
    }

    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    /// As the console opens it.
    void open(bool unpaced = false) {
        const auto recording = Recording::open(path());
        ASSERT_TRUE(recording);
        const auto sources = pipeline::recordedSources(*recording);
        ASSERT_TRUE(sources) << core::describe(sources.error());
        ASSERT_EQ(sources->arrays.size(), 1U);
        replay::RecordedConfig config;
        config.path = path();
        config.stream = sources->arrays[0].arrayStream;
        config.temperatureStream = sources->arrays[0].temperatureStream;
        config.chips = sources->arrays[0].chips;
        config.array = sources->arrays[0].array.description;
        config.autoplay = false;
        if (unpaced) {
            config.speed = std::numeric_limits<double>::infinity();
            config.queueJoints = 64;
        } else {
            config.clock = m_clock;
        }
        auto player = replay::RecordedPlayer::open(std::move(config));
        ASSERT_TRUE(player) << core::describe(player.error());
        m_array = std::make_unique<replay::RecordedArray>(*player);
    }
    bool comesTo(core::DeviceState state) {
        return eventually(m_wakeup, [&] { return m_array->status().state == state; });
    }
    std::vector<float> told() {
        std::vector<float> values;
        core::TemperatureSample sample;
        while (m_array->temperatures().pop(sample)) {
            EXPECT_EQ(sample.values_degC.size(), 2U);
            EXPECT_EQ(sample.values_degC.back(), 20.25F);
            values.push_back(sample.values_degC.front());
            m_jumps += sample.discontinuity ? 1 : 0;
        }
        return values;
    }

    TemporaryFolder m_folder;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
    std::unique_ptr<replay::RecordedArray> m_array;
    int m_jumps = 0;
};

} // namespace

TEST_F(RecordedTemperatures, arePlayedUpToTheFrameThatIsShown) {
    write(31);
    ASSERT_NO_FATAL_FAILURE(open());
    EXPECT_EQ(m_array->chips(), 2U);
    m_array->start(m_wakeup);
    m_clock->settle();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    EXPECT_EQ(told(), std::vector<float>{0.0F});
    m_array->play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(12 * kPeriod_ns);
    EXPECT_EQ(told(), (std::vector<float>{5.0F, 10.0F}));
    EXPECT_EQ(m_jumps, 1) << "the first one";
    m_array->pause();
    ASSERT_TRUE(comesTo(core::DeviceState::paused));
    m_array->seek(0.285);
    // What was told last before the frame that is shown is known too.
    EXPECT_TRUE(eventually(m_wakeup, [&] { return told() == std::vector<float>{25.0F}; }));
    EXPECT_EQ(m_jumps, 2);
    m_array->play();
    ASSERT_TRUE(comesTo(core::DeviceState::live));
    m_clock->advance(20 * kPeriod_ns);
    ASSERT_TRUE(comesTo(core::DeviceState::finished));
    EXPECT_EQ(told(), std::vector<float>{30.0F});
    m_array->stop();
}

TEST_F(RecordedTemperatures, noneIsLostAsFastAsPossible) {
    constexpr int kFrames = 1000; // with more temperatures than the queue holds
    write(kFrames);
    ASSERT_NO_FATAL_FAILURE(open(true));
    m_array->start(m_wakeup);
    m_array->play();
    float next = 0.0F;
    EXPECT_TRUE(eventually(m_wakeup, [&] {
        for (core::SampleBlock block; m_array->blocks().pop(block);) {
        }
        for (const float value : told()) {
            EXPECT_EQ(value, next);
            next = value + 5.0F;
        }
        return next >= static_cast<float>(kFrames);
    }));
    EXPECT_EQ(m_array->temperatures().overflow(), 0U);
    m_array->stop();
}

TEST_F(RecordedTemperatures, thoseOfATareOfAnotherNumberOfChipsAreRefused) {
    pipeline::ChannelSettings settings;
    settings.conditioning.tare.assign(6, 0.5F);
    for (const std::size_t atTare : {0U, 1U, 2U, 3U}) {
        settings.tareTemperatures_degC.assign(atTare, 25.5F);
        ASSERT_NO_FATAL_FAILURE(write(11, "skin-temperatures", settings));
        const auto recording = Recording::open(path());
        ASSERT_TRUE(recording);
        const auto sources = pipeline::recordedSources(*recording);
        EXPECT_EQ(sources.has_value(), atTare == 0 || atTare == 2) << atTare;
        if (!sources) {
            const std::string why = core::describe(sources.error());
            EXPECT_EQ(sources.error().kind, core::ErrorKind::badInput);
            EXPECT_NE(why.find("tare_temperatures_degc"), std::string::npos) << why;
            EXPECT_NE(why.find("length 2"), std::string::npos) << why;
        }
        std::filesystem::remove(path());
    }
}

TEST_F(RecordedTemperatures, thoseOfAnotherArrayAreNotItsOwn) {
    write(11, "other-temperatures");
    ASSERT_NO_FATAL_FAILURE(open());
    EXPECT_EQ(m_array->chips(), 0U);
}
