// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/stream_time.h"

#include <gtest/gtest.h>

namespace teleta::taxels {
namespace {

BinaryFormat withCounter(NumberType type) {
    BinaryFormat format;
    format.counter = NumberField{.type = type};
    return format;
}

StreamTime::Step counted(StreamTime& time, std::uint32_t counter) {
    DecodedFrame frame;
    frame.counter = counter;
    return time.advance(frame, 1.0);
}

TEST(StreamTime, countsWhatIsMissingBetweenTwoCountersAlsoWhereTheyWrap) {
    StreamTime time(withCounter(NumberType::uint8));
    EXPECT_EQ(counted(time, 253).lost, 0U) << "of the first frame nothing is known";
    EXPECT_EQ(counted(time, 254).lost, 0U);
    EXPECT_EQ(counted(time, 1).lost, 2U); // 255 and 0
    EXPECT_EQ(counted(time, 2).lost, 0U);
    EXPECT_EQ(counted(time, 129).lost, 126U);
}

TEST(StreamTime, tellsARepeatedFrameAndARestartFromALoss) {
    StreamTime time(withCounter(NumberType::uint16));
    EXPECT_FALSE(counted(time, 700).repeated);
    EXPECT_TRUE(counted(time, 700).repeated);
    EXPECT_FALSE(counted(time, 701).repeated);
    const StreamTime::Step again = counted(time, 0);
    EXPECT_TRUE(again.restarted);
    EXPECT_EQ(again.lost, 0U);
    time.beginConnection();
    EXPECT_FALSE(counted(time, 40'000).restarted) << "another connection may begin anywhere";
}

TEST(StreamTime, followsTheSensorsTimeOverItsWrap) {
    BinaryFormat format;
    format.time = TimeField{.field = {.type = NumberType::uint16}, .unit_s = 1e-3};
    StreamTime time(format);
    DecodedFrame frame;
    double before_s = 0.0;
    for (int i = 0; i < 30; ++i) {
        frame.ticks = static_cast<std::uint32_t>(65'500 + 10 * i) & 0xFFFFU;
        const StreamTime::Step step = time.advance(frame, 2.0);
        EXPECT_EQ(step.lost, 0U);
        EXPECT_FALSE(step.restarted);
        if (i > 0) {
            EXPECT_NEAR(step.time_s - before_s, 0.010, 1e-12);
        }
        before_s = step.time_s;
    }
    frame.ticks = (65'500U + 10U * 32U) & 0xFFFFU; // two of them did not come
    EXPECT_EQ(time.advance(frame, 2.0).lost, 2U);
}

TEST(StreamTime, takesSecondsAsTheyAreAndNeverGoesBack) {
    StreamTime time{JsonFormat{}};
    DecodedFrame frame;
    const auto at = [&](double time_s, double host_s) {
        frame.time_s = time_s;
        return time.advance(frame, host_s);
    };
    EXPECT_DOUBLE_EQ(at(1e9, 0.5).time_s, 0.5);
    EXPECT_DOUBLE_EQ(at(1e9 + 0.25, 9.0).time_s, 0.75);
    const StreamTime::Step back = at(10.0, 3.0);
    EXPECT_TRUE(back.restarted);
    EXPECT_DOUBLE_EQ(back.time_s, 3.0);
    EXPECT_DOUBLE_EQ(at(10.5, 3.1).time_s, 3.5);
}

TEST(StreamTime, countsNoIntervalTwiceWhenSomeFramesLackTheirTime) {
    StreamTime time{JsonFormat{.mayLackTime = true}};
    DecodedFrame frame;
    const auto at = [&](std::optional<double> time_s, double host_s) {
        frame.time_s = time_s;
        return time.advance(frame, host_s).time_s;
    };
    EXPECT_DOUBLE_EQ(at(1e9, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(at(std::nullopt, 0.75), 0.75);
    EXPECT_DOUBLE_EQ(at(1e9 + 0.5, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(at(1e9 + 0.75, 1.5), 1.25);
}

TEST(StreamTime, knowsWhetherLossesCanBeCounted) {
    BinaryFormat binary;
    EXPECT_FALSE(countsLosses(binary)) << "as of AnySkin";
    binary.time = TimeField{};
    EXPECT_TRUE(countsLosses(binary));
    binary.time->field.type = NumberType::float32;
    EXPECT_FALSE(countsLosses(binary)) << "no whole number";
    binary.counter = NumberField{};
    EXPECT_TRUE(countsLosses(binary));
    EXPECT_FALSE(countsLosses(CsvFormat{.timeColumn = 1}));
    EXPECT_FALSE(countsLosses(JsonFormat{.time = "/t"}));
    EXPECT_TRUE(countsLosses(JsonFormat{.counter = "/message"}));
}

TEST(StreamTime, isTheHostsWithoutAnyOther) {
    StreamTime time{CsvFormat{}};
    EXPECT_DOUBLE_EQ(time.advance({}, 0.1).time_s, 0.1);
    EXPECT_DOUBLE_EQ(time.advance({}, 0.2).time_s, 0.2);
}

} // namespace
} // namespace teleta::taxels
