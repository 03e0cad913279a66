// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch_channel.h"
#include "backend/pipeline/touch_pipeline.h"
#include "tests/backend/pipeline/next_event.h"
#include "tests/backend/pipeline/scripted_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using teleta::core::ArrayLayout;
using teleta::core::Error;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::core::Unexpected;
using teleta::pipeline::Channel;
using teleta::pipeline::ChannelEvent;
using teleta::pipeline::FeatureSample;
using teleta::pipeline::TouchChannel;
using teleta::pipeline::TouchPipeline;
using teleta::test::nextEvent;
using teleta::test::ScriptedSource;

namespace {

constexpr ArrayLayout kLayout{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

/// Opens a scripted source and hands out the channel and a pointer to the source.
std::shared_ptr<TouchChannel> openScripted(TouchPipeline& pipeline, ScriptedSource*& source) {
    pipeline.open([&]() -> Expected<std::shared_ptr<Channel>> {
        auto made = std::make_unique<ScriptedSource>(kLayout);
        source = made.get();
        return std::make_shared<TouchChannel>(std::move(made), teleta::pipeline::ChannelSettings());
    });
    return std::dynamic_pointer_cast<TouchChannel>(nextEvent(pipeline).channel);
}

} // namespace

TEST(TouchPipeline, reportsThatASourceCouldNotBeOpened) {
    TouchPipeline pipeline;
    const auto key = pipeline.open([]() -> Expected<std::shared_ptr<Channel>> {
        return Unexpected(Error{ErrorKind::notFound, "no such file", "", {}});
    });
    const ChannelEvent event = nextEvent(pipeline);
    EXPECT_EQ(event.kind, ChannelEvent::Kind::failed);
    EXPECT_EQ(event.key, key);
    EXPECT_EQ(event.error.message, "no such file");
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
    EXPECT_EQ(nextEvent(pipeline).kind, ChannelEvent::Kind::closed);
    EXPECT_EQ(source->stops(), 1);
    EXPECT_EQ(channel->snapshot().frame, 0U);
}

TEST(TouchPipeline, ignoresTheClosingOfASourceThatIsNotOpen) {
    TouchPipeline pipeline;
    pipeline.close(7);
    ScriptedSource* source = nullptr;
    EXPECT_TRUE(openScripted(pipeline, source)) << "the first event is that of the next request";
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
