// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/source_request.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/pipeline/touch_pipeline.h"
#include "tests/backend/pipeline/next_event.h"
#include "tests/devices/manual_clock.h"
#include "tests/devices/wts/emulated_wts.h"

#include <gtest/gtest.h>

namespace teleta::console {
namespace {

using wts::test::EmulatedWts;

app::WtsRequest requestFor(const EmulatedWts& sensor) {
    app::WtsRequest request;
    request.config.address = *wts::parseWtsAddress(sensor.address());
    request.config.times = {.answer_ms = 5000, .stale_ms = 20000, .noFrames_ms = 20000};
    return request;
}

core::Expected<std::shared_ptr<pipeline::TouchChannel>> open(const app::WtsRequest& request) {
    static const core::StopSwitch stop;
    return app::makeSourceFactory(request, stop)().map([](const std::shared_ptr<pipeline::Channel>& channel) {
        return std::dynamic_pointer_cast<pipeline::TouchChannel>(channel);
    });
}

TEST(WtsSource, takesAHundredthOfTheFullScaleForNoise) {
    EmulatedWts sensor(EmulatedWts::Link::pty);
    const auto opened = open(requestFor(sensor));
    ASSERT_TRUE(opened) << core::describe(opened.error());
    EXPECT_DOUBLE_EQ((*opened)->settings().features.threshold_N, 40.95);
    EXPECT_DOUBLE_EQ((*opened)->settings().segmentation.threshold_N, 40.95);
    EXPECT_EQ((*opened)->settings().loadUnit, "counts");
    EXPECT_EQ((*opened)->description().layout, (core::ArrayLayout{6, 14, 0.0034}));
}

TEST(WtsSource, showsForcesWhenItKnowsTheGain) {
    EmulatedWts sensor(EmulatedWts::Link::tcp);
    app::WtsRequest request = requestFor(sensor);
    request.gain = 0.002;
    request.loadUnit = std::string("N");
    const auto opened = open(request);
    ASSERT_TRUE(opened) << core::describe(opened.error());
    EXPECT_DOUBLE_EQ((*opened)->settings().features.threshold_N, 0.0819); // 1 % of 4095 counts of 2 mN
    EXPECT_DOUBLE_EQ((*opened)->settings().conditioning.gain, 0.002);
    EXPECT_EQ((*opened)->settings().loadUnit, "N");
}

TEST(WtsSource, takesTheThresholdThatItIsGiven) {
    EmulatedWts sensor(EmulatedWts::Link::pty);
    app::WtsRequest request = requestFor(sensor);
    request.threshold = 0.5;
    const auto opened = open(request);
    ASSERT_TRUE(opened) << core::describe(opened.error());
    EXPECT_DOUBLE_EQ((*opened)->settings().features.threshold_N, 0.5);
}

TEST(WtsSource, reachesTheViewsThroughThePipeline) {
    EmulatedWts sensor(EmulatedWts::Link::pty);
    const core::StopSwitch stop;
    pipeline::TouchPipeline pipeline;
    pipeline.open(app::makeSourceFactory(requestFor(sensor), stop));
    const pipeline::ChannelEvent event = test::nextEvent(pipeline);
    ASSERT_EQ(event.kind, pipeline::ChannelEvent::Kind::opened) << core::describe(event.error);
    ASSERT_TRUE(sensor.waitForRequests(wts::Command::startFrames, 1));
    std::vector<unsigned> cells(84);
    cells[20] = 1000;
    ASSERT_TRUE(sensor.send(wts::test::frame(1, false, cells)));

    auto& channel = dynamic_cast<pipeline::TouchChannel&>(*event.channel);
    core::Wakeup never;
    ASSERT_TRUE(teleta::test::eventually(never, [&] { return channel.update(); }));
    EXPECT_EQ(channel.snapshot().loadUnit, "counts");
    EXPECT_EQ(channel.snapshot().load_N.at(20), 1000.0F);
    ASSERT_EQ(channel.snapshot().contacts.size(), 1U);
}

TEST(WtsSource, saysThatThereIsNoPort) {
    app::WtsRequest request;
    request.config.address = wts::SerialAddress{"/dev/no-such-port"};
    const auto opened = open(request);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, core::ErrorKind::notFound);
}

} // namespace
} // namespace teleta::console
