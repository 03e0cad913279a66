// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_sink.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using teleta::contact::ContactType;
using teleta::core::ArrayLayout;
using teleta::pipeline::ChannelSettings;
using teleta::pipeline::FeatureSample;
using teleta::pipeline::TouchChannel;
using teleta::test::ScriptedSource;

namespace {

constexpr ArrayLayout kLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};

struct Channel {
    explicit Channel(ChannelSettings settings = {}, std::size_t capacity = 64) {
        auto owned = std::make_unique<ScriptedSource>(kLayout, capacity);
        source = owned.get();
        channel = std::make_unique<TouchChannel>(std::move(owned), std::move(settings));
    }
    TouchChannel* operator->() const { return channel.get(); }

    ScriptedSource* source = nullptr;
    std::unique_ptr<TouchChannel> channel;
};

} // namespace

TEST(TouchChannel, joinsTheTwoPartsOfAContactAtTheSeamOfASheetAroundACylinder) {
    // 6 rows of 3.4 mm close around a cylinder: the first row is the neighbour of the last one.
    constexpr ArrayLayout kSheet{.rows = 6, .columns = 14, .pitchX_m = 0.0034};
    auto made = std::make_unique<ScriptedSource>(kSheet);
    ScriptedSource& source = *made;
    TouchChannel channel(std::move(made), {});
    std::vector<float> values(kSheet.taxels());
    values[3] = 1.0F;          // first row
    values[5 * 14 + 3] = 3.0F; // last row
    source.push(values, 0.005);
    std::vector<teleta::pipeline::SkinContact> contacts;
    const auto process = [&](double circumference_m) {
        channel.process([&](const teleta::pipeline::TouchSnapshot& frame) {
            contacts.push_back(teleta::pipeline::strongestContact(frame, circumference_m));
        });
    };
    process(6 * kSheet.pitchX_m);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_TRUE(contacts[0].touching);
    EXPECT_NEAR(contacts[0].force_N, 4.0, 1e-9);
    EXPECT_NEAR(contacts[0].x_m, kSheet.x_m(3), 1e-12);
    EXPECT_NEAR(contacts[0].y_m, kSheet.y_m(5.25), 1e-12);
    source.push(values, 0.010);
    process(0.0); // flat: they are two
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_NEAR(contacts[1].force_N, 3.0, 1e-9);
    EXPECT_NEAR(contacts[1].y_m, kSheet.y_m(5), 1e-12);
    source.push(std::vector<float>(kSheet.taxels()), 0.015);
    process(6 * kSheet.pitchX_m);
    EXPECT_FALSE(contacts[2].touching);
}

TEST(TouchChannel, showsNothingBeforeTheFirstFrame) {
    Channel channel;
    EXPECT_EQ(channel->process(), 0U);
    EXPECT_FALSE(channel->update());
    EXPECT_EQ(channel->generation(), 0U);
}

TEST(TouchChannel, turnsAFrameIntoContactsAndFeatures) {
    Channel channel;
    channel.source->push({0, 0, 0, 0, 0, 3}, 0.25);
    EXPECT_EQ(channel->process(), 1U);
    ASSERT_TRUE(channel->update());

    const auto& snapshot = channel->snapshot();
    EXPECT_EQ(snapshot.layout, kLayout);
    EXPECT_DOUBLE_EQ(snapshot.sourceTime_s, 0.25);
    EXPECT_DOUBLE_EQ(snapshot.features.force_N, 3.0);
    EXPECT_EQ(snapshot.features.type, ContactType::point);
    ASSERT_EQ(snapshot.contacts.size(), 1U);
    EXPECT_EQ(snapshot.contacts.front().id, 1);
    EXPECT_DOUBLE_EQ(snapshot.contacts.front().x_m, 0.01);
    EXPECT_DOUBLE_EQ(snapshot.contacts.front().y_m, 0.005);
    EXPECT_EQ(snapshot.labels[5], snapshot.contacts.front().region);
    EXPECT_EQ(snapshot.labels[0], 0);
}

TEST(TouchChannel, givesTheViewerEveryFrameAsASampleAndOnlyTheNewestAsASnapshot) {
    Channel channel;
    for (int frame = 0; frame < 5; ++frame)
        channel.source->push({float(frame), 0, 0, 0, 0, 0}, 0.1 * frame);
    EXPECT_EQ(channel->process(), 5U);
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->generation(), 1U);
    EXPECT_DOUBLE_EQ(channel->snapshot().features.force_N, 4.0);

    FeatureSample sample;
    for (int frame = 0; frame < 5; ++frame) {
        ASSERT_TRUE(channel->popSample(sample));
        EXPECT_DOUBLE_EQ(sample.features.force_N, frame);
        EXPECT_DOUBLE_EQ(sample.sourceTime_s, 0.1 * frame);
    }
    EXPECT_FALSE(channel->popSample(sample));
    EXPECT_EQ(channel->framesProcessed(), 5U);
}

TEST(TouchChannel, takesWhatWaitedWhenItWasAskedAndNotWhatComesMeanwhile) {
    /// A recording that is played as fast as it is read: there is always one more frame.
    class EndlessSource : public ScriptedSource {
    public:
        using ScriptedSource::ScriptedSource;
        [[nodiscard]] teleta::core::BoundedQueue<teleta::core::SampleBlock>& blocks() override {
            if (m_left-- > 0)
                push({1, 0, 0, 0, 0, 0}, 0.0);
            return ScriptedSource::blocks();
        }

    private:
        int m_left = 10'000;
    };
    auto made = std::make_unique<EndlessSource>(kLayout);
    made->push({1, 0, 0, 0, 0, 0}, 0.0);
    TouchChannel channel(std::move(made), {});
    EXPECT_EQ(channel.process(), 2U);
    EXPECT_EQ(channel.process(), 1U);
}

TEST(TouchChannel, countsSamplesThatALateViewerMisses) {
    constexpr std::size_t kLate = 10;
    Channel channel({}, TouchChannel::kHistorySamples + kLate);
    for (std::size_t frame = 0; frame < TouchChannel::kHistorySamples + kLate; ++frame)
        ASSERT_TRUE(channel.source->push({1, 0, 0, 0, 0, 0}, 0.005 * static_cast<double>(frame)));
    channel->process();
    EXPECT_EQ(channel->samplesNotShown(), kLate);
    EXPECT_EQ(channel->framesProcessed(), TouchChannel::kHistorySamples + kLate);
}

TEST(TouchChannel, appliesNewSettingsToTheLastFrameOfAPausedSource) {
    Channel channel;
    channel.source->push({2, 0, 0, 0, 0, 0}, 0.0);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_DOUBLE_EQ(channel->snapshot().features.force_N, 2.0);

    ChannelSettings settings = channel->settings();
    settings.conditioning.gain = 10.0;
    channel->post(settings);
    EXPECT_EQ(channel->process(), 0U);
    ASSERT_TRUE(channel->update());
    EXPECT_DOUBLE_EQ(channel->snapshot().features.force_N, 20.0);
    EXPECT_EQ(channel->settingsRevision(), 1U);
    EXPECT_EQ(channel->framesProcessed(), 1U) << "looking again at a frame is not a new frame";
}

TEST(TouchChannel, newSettingsLeaveWhatWasMeasuredOfTheArray) {
    Channel channel;
    channel->setTaxelGain({2, 1, 1, 1, 1, 0.5F});
    channel.source->push({1, 0, 0, 0, 0, 8}, 0.0);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().load_N, (std::vector<float>{2, 0, 0, 0, 0, 4}));

    ChannelSettings settings; // of a panel that knows neither tare nor gains
    settings.conditioning.gain = 10.0;
    channel->post(settings);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().load_N, (std::vector<float>{20, 0, 0, 0, 0, 40}));
    EXPECT_EQ(channel->settings().conditioning.taxelGain.size(), kLayout.taxels());

    channel->setTaxelGain({});
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().load_N, (std::vector<float>{10, 0, 0, 0, 0, 80}));
}

TEST(TouchChannel, handsRawFramesToWhoCollectsThem) {
    Channel channel;
    const auto tap = std::make_shared<teleta::core::StreamTap>(8);
    channel->collect(tap);
    channel->setTaxelGain({2, 2, 2, 2, 2, 2});
    channel.source->push({1, 2, 3, 4, 5, 6}, 0.5);
    channel->process();
    channel->collect(nullptr);
    channel.source->push({7, 7, 7, 7, 7, 7}, 0.6);
    channel->process();
    teleta::core::TappedFrames frames;
    ASSERT_TRUE(tap->pop(frames));
    EXPECT_EQ(frames.sourceTime_s, std::vector<double>{0.5});
    std::vector<float> raw(6);
    ASSERT_EQ(frames.values.size(), 6 * sizeof(float));
    std::memcpy(raw.data(), frames.values.data(), frames.values.size());
    EXPECT_EQ(raw, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_FALSE(tap->pop(frames));
}

TEST(TouchChannel, givesItsStreamsToWhoWatchesWhetherItIsRecordedOrNot) {
    class Sink : public teleta::recording::StreamSink {
    public:
        std::shared_ptr<teleta::core::StreamTap> addStream(teleta::recording::StreamInfo info) override {
            names.push_back(info.name);
            taps.push_back(std::make_shared<teleta::core::StreamTap>(8));
            return taps.back();
        }
        void add(teleta::recording::RecordingEvent /*event*/) override {}
        std::vector<std::string> names;
        std::vector<std::shared_ptr<teleta::core::StreamTap>> taps;
    };
    const auto sink = std::make_shared<Sink>();
    Channel channel;
    channel->watch(teleta::pipeline::Watcher::plot, sink, "skin");
    const auto other = std::make_shared<Sink>();
    channel->watch(teleta::pipeline::Watcher::liveView, other, "other");
    EXPECT_EQ(sink->names, (std::vector<std::string>{"skin-frames", "skin-features"}));
    channel.source->push({1, 2, 3, 4, 5, 6}, 0.005);
    channel->process();
    teleta::core::TappedFrames frames;
    ASSERT_TRUE(sink->taps[0]->pop(frames));
    EXPECT_EQ(teleta::recording::valuesOf<float>(frames, 0, 6)[5], 6.0F);
    ASSERT_TRUE(sink->taps[1]->pop(frames));
    EXPECT_EQ(teleta::recording::valuesOf<double>(frames, 0, 12)[1], 21.0) << "force_n";
    EXPECT_TRUE(other->taps[0]->pop(frames)) << "both watch at once";
    channel->watch(teleta::pipeline::Watcher::plot, nullptr, {});
    EXPECT_EQ(sink->taps[0].use_count(), 1) << "it lets go of the taps";
    EXPECT_EQ(other->taps[0].use_count(), 2) << "the other one goes on";
    channel.source->push({1, 2, 3, 4, 5, 6}, 0.010);
    channel->process();
    EXPECT_FALSE(sink->taps[0]->pop(frames));
}

TEST(TouchChannel, taresWithTheMeanOfTheFramesInTheGivenTime) {
    Channel channel;
    channel->requestTare(0.2);
    channel.source->push({10, 20, 0, 0, 0, 0}, 1.0);
    channel.source->push({12, 20, 0, 0, 0, 0}, 1.1);
    channel.source->push({14, 20, 0, 0, 0, 0}, 1.2);
    channel.source->push({13, 25, 0, 0, 0, 0}, 1.3);
    channel->process();
    ASSERT_TRUE(channel->update());
    ASSERT_EQ(channel->settings().conditioning.tare.size(), kLayout.taxels());
    EXPECT_FLOAT_EQ(channel->settings().conditioning.tare[0], 12.0F);
    EXPECT_FLOAT_EQ(channel->settings().conditioning.tare[1], 20.0F);
    EXPECT_DOUBLE_EQ(channel->snapshot().features.force_N, 1.0 + 5.0);
}

TEST(TouchChannel, keepsTheTareWhenAPanelPostsSettingsWithoutIt) {
    Channel channel;
    channel->requestTare(0.0);
    channel.source->push({10, 0, 0, 0, 0, 0}, 0.0);
    channel->process();
    EXPECT_FLOAT_EQ(channel->settings().conditioning.tare.at(0), 10.0F);

    ChannelSettings settings;
    settings.conditioning.gain = 2.0;
    channel->post(settings);
    channel->process();
    EXPECT_FLOAT_EQ(channel->settings().conditioning.tare.at(0), 10.0F);
    EXPECT_DOUBLE_EQ(channel->settings().conditioning.gain, 2.0);

    channel->clearTare();
    channel->process();
    EXPECT_TRUE(channel->settings().conditioning.tare.empty());
}

TEST(TouchChannel, marksATaxelThatNeverReadsAsDeadWhenTaring) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    Channel channel;
    channel->requestTare(0.0);
    channel.source->push({kNaN, 1, 1, 1, 1, 1}, 0.0);
    channel->process();
    EXPECT_TRUE(std::isnan(channel->settings().conditioning.tare.at(0)));

    channel.source->push({5, 1, 1, 1, 1, 1}, 0.1);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().features.dead, 1);
    EXPECT_EQ(channel->snapshot().dead[0], 1);
}

TEST(TouchChannel, startsIdentitiesAnewAfterAJumpInTheStream) {
    Channel channel;
    channel.source->push({1, 0, 0, 0, 0, 0}, 0.0);
    channel.source->push({0, 0, 0, 0, 0, 1}, 0.01);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().contacts.front().id, 2) << "22 mm away is another contact";

    channel.source->push({0, 0, 0, 0, 0, 1}, 0.0, true);
    channel->process();
    ASSERT_TRUE(channel->update());
    EXPECT_EQ(channel->snapshot().contacts.front().id, 1);
}

TEST(TouchChannel, ignoresABlockOfAnotherSize) {
    Channel channel;
    channel.source->push({1, 2}, 0.0);
    EXPECT_EQ(channel->process(), 0U);
    EXPECT_FALSE(channel->update());
}
