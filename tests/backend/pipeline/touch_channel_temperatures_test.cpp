// SPDX-License-Identifier: GPL-3.0-or-later
// An array whose chips tell how warm they are.
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using teleta::core::ArrayLayout;
using teleta::pipeline::ChannelSettings;
using teleta::pipeline::TouchChannel;

namespace {

class WarmSource : public teleta::test::ScriptedSource, public teleta::core::ChipThermometers {
public:
    explicit WarmSource(std::size_t chips)
        : ScriptedSource(ArrayLayout{.rows = 1, .columns = 2, .pitchX_m = 0.01})
        , m_chips(chips) {}

    [[nodiscard]] std::size_t chips() const override { return m_chips; }
    [[nodiscard]] teleta::core::BoundedQueue<teleta::core::TemperatureSample>& temperatures() override {
        return m_temperatures;
    }
    /// A frame with its temperatures.
    void push(double time_s, std::vector<float> values_degC) {
        m_temperatures.push({teleta::core::steadyNow_ns(), time_s, std::move(values_degC)});
        ScriptedSource::push({1.0F, 2.0F}, time_s);
    }

private:
    std::size_t m_chips;
    teleta::core::BoundedQueue<teleta::core::TemperatureSample> m_temperatures{64};
};

class WarmChannel : public testing::Test {
protected:
    explicit WarmChannel(std::size_t chips = 2) {
        auto owned = std::make_unique<WarmSource>(chips);
        m_source = owned.get();
        ChannelSettings settings;
        settings.conditioning.tare = {1.0F, 1.0F}; // as it was measured at opening,
        settings.tareTemperatures_degC = {25.0F, 26.0F};
        m_channel = std::make_unique<TouchChannel>(std::move(owned), std::move(settings));
    }
    void frame(double time_s, std::vector<float> values_degC) {
        m_source->push(time_s, std::move(values_degC));
        m_channel->process();
    }

    WarmSource* m_source = nullptr;
    std::unique_ptr<TouchChannel> m_channel;
};

} // namespace

TEST_F(WarmChannel, tellsThatAChipMovedMoreThanFiveKelvinFromTheTare) {
    frame(0.0, {25.0F, 26.0F});
    frame(0.1, {29.0F, 31.0F});
    EXPECT_FALSE(m_channel->temperatureDrift());
    frame(0.2, {29.0F, 32.5F});
    ASSERT_TRUE(m_channel->temperatureDrift());
    EXPECT_EQ(m_channel->temperatureDrift()->chip, 1U);
    EXPECT_DOUBLE_EQ(m_channel->temperatureDrift()->change_K, 6.5);

    m_channel->requestTare(0.05);
    frame(0.3, {29.0F, 32.5F});
    frame(0.4, {29.0F, 32.5F});
    EXPECT_FALSE(m_channel->temperatureDrift()) << "the new tare was taken at these temperatures";
    frame(0.5, {29.0F, 26.0F});
    ASSERT_TRUE(m_channel->temperatureDrift());
    EXPECT_DOUBLE_EQ(m_channel->temperatureDrift()->change_K, -6.5);
}

TEST_F(WarmChannel, withoutATareThereIsNothingThatDrifts) {
    m_channel->clearTare();
    frame(0.0, {25.0F, 26.0F});
    frame(0.1, {45.0F, 46.0F});
    EXPECT_FALSE(m_channel->temperatureDrift());
}

TEST_F(WarmChannel, aPlaybackTellsTheDriftFromTheTareThatWasRecorded) {
    frame(0.0, {25.0F, 26.0F});
    frame(0.1, {28.0F, 26.0F});
    const ChannelSettings recorded = m_channel->settings();
    EXPECT_EQ(recorded.tareTemperatures_degC, (std::vector<float>{25.0F, 26.0F}));
    auto owned = std::make_unique<WarmSource>(2);
    WarmSource* source = owned.get();
    TouchChannel again(std::move(owned), recorded);
    source->push(0.0, {31.0F, 26.0F}); // the first that is played
    again.process();
    ASSERT_TRUE(again.temperatureDrift());
    EXPECT_EQ(again.temperatureDrift()->chip, 0U);
    EXPECT_DOUBLE_EQ(again.temperatureDrift()->change_K, 6.0);

    // Settings of views, and those of a new tare.
    ChannelSettings other = recorded;
    other.tareTemperatures_degC.clear();
    m_channel->post(other);
    frame(0.2, {28.0F, 26.0F});
    EXPECT_EQ(m_channel->settings().tareTemperatures_degC, (std::vector<float>{25.0F, 26.0F}));
    const std::uint64_t before = m_channel->settingsRevision();
    m_channel->requestTare(0.05);
    frame(0.3, {28.0F, 26.0F});
    frame(0.4, {28.5F, 26.0F});
    EXPECT_EQ(m_channel->settings().tareTemperatures_degC, (std::vector<float>{28.5F, 26.0F}));
    EXPECT_EQ(m_channel->settingsRevision(), before + 2) << "the tare, then its temperatures";
    frame(0.45, {28.5F, 26.0F});
    EXPECT_EQ(m_channel->settingsRevision(), before + 2);
    m_channel->clearTare();
    frame(0.5, {28.5F, 26.0F});
    EXPECT_TRUE(m_channel->settings().tareTemperatures_degC.empty());
}

TEST_F(WarmChannel, aTareAtUnknownTemperaturesTellsNoDrift) {
    for (const std::vector<float>& recorded :
         {std::vector<float>{}, {25.0F}, {25.0F, 26.0F, 27.0F}}) { // none, and of another number of chips
        auto owned = std::make_unique<WarmSource>(2);
        WarmSource* source = owned.get();
        ChannelSettings settings;
        settings.conditioning.tare = {1.0F, 1.0F};
        settings.tareTemperatures_degC = recorded;
        TouchChannel played(std::move(owned), settings);
        const auto play = [&](double time_s, std::vector<float> values_degC) {
            source->push(time_s, std::move(values_degC));
            played.process();
        };
        play(0.0, {20.0F, 20.0F});
        play(0.1, {40.0F, 40.0F}); // after a seek
        EXPECT_FALSE(played.temperatureDrift()) << recorded.size();
        EXPECT_EQ(played.settings().tareTemperatures_degC, recorded) << "nothing is made up";
        EXPECT_EQ(played.settingsRevision(), 0U) << recorded.size();

        played.requestTare(0.05);
        play(0.2, {40.0F, 40.0F});
        play(0.3, {40.0F, 40.0F});
        EXPECT_EQ(played.settings().tareTemperatures_degC, (std::vector<float>{40.0F, 40.0F}));
        play(0.4, {40.0F, 30.0F});
        EXPECT_TRUE(played.temperatureDrift()) << "from a tare that was taken here";
    }
}

TEST_F(WarmChannel, theEventsOfARecordingHaveTheTemperaturesOfATareThatComeAfterIt) {
    const teleta::test::TemporaryFolder folder;
    auto started = teleta::recording::Recorder::start(folder.path("skin.teleta"), {});
    ASSERT_TRUE(started) << teleta::core::describe(started.error());
    m_channel->record(std::move(*started), "skin");
    frame(0.0, {25.0F, 26.0F});
    EXPECT_FALSE(m_channel->takeSettingsEvent());
    m_channel->requestTare(0.05);
    for (const double time_s : {0.1, 0.2}) { // frames whose temperatures are still on their way
        m_source->ScriptedSource::push({1.0F, 2.0F}, time_s);
        m_channel->process();
    }
    const auto tared = m_channel->takeSettingsEvent();
    ASSERT_TRUE(tared);
    EXPECT_EQ(tared->text.find("tare_temperatures_degc"), std::string::npos);
    frame(0.3, {28.0F, 26.5F});
    const auto known = m_channel->takeSettingsEvent();
    ASSERT_TRUE(known);
    EXPECT_NE(known->text.find("\"tare_temperatures_degc\":[28.0,26.5]"), std::string::npos) << known->text;
    frame(0.4, {29.0F, 26.5F});
    EXPECT_FALSE(m_channel->takeSettingsEvent());
    m_channel->record(nullptr, {});
}

TEST_F(WarmChannel, aRecordingHasTheTemperatures) {
    const teleta::test::TemporaryFolder folder;
    const std::string path = folder.path("skin.teleta");
    auto started = teleta::recording::Recorder::start(path, {});
    ASSERT_TRUE(started) << teleta::core::describe(started.error());
    const std::shared_ptr<teleta::recording::Recorder> recorder = std::move(*started);
    m_channel->record(recorder, "skin");
    for (int i = 0; i < 10; ++i)
        frame(0.5 * i, {25.0F + static_cast<float>(i), 20.25F});
    ASSERT_TRUE(recorder->stop());

    const auto recording = teleta::recording::Recording::open(path);
    ASSERT_TRUE(recording) << teleta::core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 3U);
    const teleta::recording::StreamInfo& stream = recording->streams()[2];
    EXPECT_EQ(stream.name, "skin-temperatures");
    EXPECT_EQ(stream.kind, teleta::recording::StreamKind::numbers);
    ASSERT_EQ(stream.columns.size(), 2U);
    EXPECT_EQ(stream.columns[1].name, "temperature_1_degc");
    EXPECT_EQ(stream.columns[1].unit, "degC");
    teleta::recording::StreamReader reader = recording->reader(2);
    teleta::core::TappedFrames block;
    std::size_t frames = 0;
    while (reader.next(block).value_or(false))
        for (std::size_t i = 0; i < block.frames(); ++i, ++frames) {
            const auto values = teleta::recording::valuesOf<double>(block, i, 2);
            EXPECT_EQ(values[0], 25.0 + static_cast<double>(frames));
            EXPECT_EQ(values[1], 20.25);
            EXPECT_EQ(block.sourceTime_s[i], 0.5 * static_cast<double>(frames));
        }
    EXPECT_EQ(frames, 10U);
}

TEST(TouchChannel, anArrayWhoseChipsTellNothingHasNoStreamOfTemperatures) {
    const teleta::test::TemporaryFolder folder;
    auto started = teleta::recording::Recorder::start(folder.path("skin.teleta"), {});
    ASSERT_TRUE(started) << teleta::core::describe(started.error());
    const std::shared_ptr<teleta::recording::Recorder> recorder = std::move(*started);
    auto owned = std::make_unique<WarmSource>(0);
    WarmSource* source = owned.get();
    TouchChannel channel(std::move(owned), {});
    channel.record(recorder, "skin");
    source->push(0.0, {});
    channel.process();
    ASSERT_TRUE(recorder->stop());
    const auto recording = teleta::recording::Recording::open(folder.path("skin.teleta"));
    ASSERT_TRUE(recording) << teleta::core::describe(recording.error());
    EXPECT_EQ(recording->streams().size(), 2U);
}
