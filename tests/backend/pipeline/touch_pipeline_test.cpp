// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch_pipeline.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using teleta::core::ArrayLayout;
using teleta::core::Error;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::core::Unexpected;
using teleta::pipeline::ChannelEvent;
using teleta::pipeline::FeatureSample;
using teleta::pipeline::OpenedSource;
using teleta::pipeline::TouchChannel;
using teleta::pipeline::TouchPipeline;
using teleta::test::ScriptedSource;

namespace {

constexpr ArrayLayout kLayout{.rows = 6, .columns = 14, .pitch_m = 0.0034};

/// Opens a scripted source and hands out the channel and a pointer to the source.
std::shared_ptr<TouchChannel> openScripted(TouchPipeline& pipeline, ScriptedSource*& source) {
    pipeline.open([&]() -> Expected<OpenedSource> {
        auto made = std::make_unique<ScriptedSource>(kLayout);
        source = made.get();
        return OpenedSource{std::move(made), {}};
    });
    pipeline.waitUntilIdle();
    auto events = pipeline.takeEvents();
    EXPECT_EQ(events.size(), 1U);
    return events.empty() ? nullptr : events.front().channel;
}

} // namespace

TEST(TouchPipeline, reportsThatASourceCouldNotBeOpened) {
    TouchPipeline pipeline;
    const auto key = pipeline.open([]() -> Expected<OpenedSource> {
        return Unexpected(Error{ErrorKind::notFound, "no such file", "", {}});
    });
    pipeline.waitUntilIdle();
    const auto events = pipeline.takeEvents();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events.front().kind, ChannelEvent::Kind::failed);
    EXPECT_EQ(events.front().key, key);
    EXPECT_EQ(events.front().error.message, "no such file");
    EXPECT_TRUE(pipeline.takeEvents().empty());
}

TEST(TouchPipeline, processesEveryFrameOfSeveralSourcesInOrder) {
    constexpr int kFrames = 2000;
    TouchPipeline pipeline;
    ScriptedSource* firstSource = nullptr;
    ScriptedSource* secondSource = nullptr;
    const auto first = openScripted(pipeline, firstSource);
    const auto second = openScripted(pipeline, secondSource);
    ASSERT_TRUE(first && second);
    ASSERT_TRUE(firstSource->started());

    const auto feed = [](ScriptedSource* source, float scale) {
        for (int frame = 1; frame <= kFrames; ++frame) {
            std::vector<float> values(kLayout.taxels());
            values[10] = scale * static_cast<float>(frame);
            while (!source->push(values, 0.005 * frame))
                std::this_thread::yield();
        }
    };
    std::jthread firstFeeder(feed, firstSource, 1.0F);
    std::jthread secondFeeder(feed, secondSource, 2.0F);

    const auto drain = [](TouchChannel& channel, double scale) {
        FeatureSample sample;
        bool ordered = true;
        for (int frame = 1; frame <= kFrames;) {
            channel.update();
            if (!channel.popSample(sample)) {
                std::this_thread::yield();
                continue;
            }
            ordered = ordered && sample.features.force_N == scale * frame;
            ++frame;
        }
        return ordered;
    };
    EXPECT_TRUE(drain(*first, 1.0));
    EXPECT_TRUE(drain(*second, 2.0));
    EXPECT_EQ(first->framesProcessed(), static_cast<std::uint64_t>(kFrames));
    EXPECT_EQ(second->samplesNotShown(), 0U);
}

TEST(TouchPipeline, stopsASourceThatIsClosedAndLeavesItsLastPictureToTheViewer) {
    TouchPipeline pipeline;
    ScriptedSource* source = nullptr;
    const auto channel = openScripted(pipeline, source);
    ASSERT_TRUE(channel);
    pipeline.close(1);
    pipeline.waitUntilIdle();
    const auto events = pipeline.takeEvents();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events.front().kind, ChannelEvent::Kind::closed);
    EXPECT_EQ(source->stops(), 1);
    EXPECT_EQ(channel->snapshot().frame, 0U);
}

TEST(TouchPipeline, ignoresTheClosingOfASourceThatIsNotOpen) {
    TouchPipeline pipeline;
    pipeline.close(7);
    pipeline.waitUntilIdle();
    EXPECT_TRUE(pipeline.takeEvents().empty());
}

TEST(TouchPipeline, endsWhileSourcesAreOpenAndRequestsWait) {
    ScriptedSource* source = nullptr;
    std::shared_ptr<TouchChannel> channel;
    {
        TouchPipeline pipeline;
        channel = openScripted(pipeline, source);
        for (int request = 0; request < 10; ++request)
            pipeline.close(99);
    }
    ASSERT_TRUE(channel);
    EXPECT_GE(source->stops(), 1);
}
