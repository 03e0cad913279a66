// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/joint_state_joiner.h"
#include "tests/backend/ros/joint_message.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::ros {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kMillisecond_ns = 1'000'000;

using core::JointVector;

TEST(JointStateJoiner, joinsByNameInAnyOrder) {
    JointStateJoiner joiner({"a", "b", "c"}, 0.1);
    JointMessage first{
        {"a", "b", "c"}, {1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}, {10.0, 20.0, 30.0}, {7, 500'000'000}};
    const auto one = joiner.take(first.message(), 0);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->position, JointVector(1.0, 2.0, 3.0));
    EXPECT_EQ(one->velocity, JointVector(0.1, 0.2, 0.3));
    EXPECT_EQ(one->effort, JointVector(10.0, 20.0, 30.0));
    EXPECT_DOUBLE_EQ(one->stamp_s, 7.5);
    JointMessage second{{"c", "a", "b"}, {3.5, 1.5, 2.5}};
    const auto two = joiner.take(second.message(), kMillisecond_ns);
    ASSERT_TRUE(two);
    EXPECT_EQ(two->position, JointVector(1.5, 2.5, 3.5));
    EXPECT_TRUE(two->velocity.empty());
    EXPECT_TRUE(two->effort.empty());
}

TEST(JointStateJoiner, waitsForTheJointsOfOtherMessages) {
    JointStateJoiner joiner({"a", "b", "c"}, 0.1);
    JointMessage ab{{"a", "b"}, {1.0, 2.0}};
    JointMessage c{{"c"}, {3.0}};
    EXPECT_FALSE(joiner.take(ab.message(), 0));
    EXPECT_EQ(joiner.missing(0), std::vector<std::size_t>{2});
    const auto joined = joiner.take(c.message(), 100 * kMillisecond_ns);
    ASSERT_TRUE(joined);
    EXPECT_EQ(joined->position, JointVector(1.0, 2.0, 3.0));
    // A nanosecond later a and b are too old.
    EXPECT_FALSE(joiner.take(c.message(), 100 * kMillisecond_ns + 1));
    EXPECT_EQ(joiner.missing(100 * kMillisecond_ns + 1), (std::vector<std::size_t>{0, 1}));
}

TEST(JointStateJoiner, namesUnknownJointsOnce) {
    JointStateJoiner joiner({"a"}, 0.1);
    JointMessage message{{"finger", "a", "", "finger_2"}, {9.0, 1.0, 5.0, 8.0}};
    const auto joined = joiner.take(message.message(), 0);
    ASSERT_TRUE(joined);
    EXPECT_EQ(joined->position.size(), 1U);
    EXPECT_EQ(joined->position[0], 1.0);
    EXPECT_EQ(joiner.takeUnknownNames(), (std::vector<std::string>{"finger", "", "finger_2"}));
    ASSERT_TRUE(joiner.take(message.message(), kMillisecond_ns));
    EXPECT_TRUE(joiner.takeUnknownNames().empty());
    EXPECT_EQ(joiner.counters().unknown, 6U);
}

TEST(JointStateJoiner, remembersAFewUnknownNamesOnly) {
    JointStateJoiner joiner({"a"}, 0.1);
    for (std::size_t i = 0; i < 3 * JointStateJoiner::kMostUnknownNames; ++i) {
        JointMessage message{{"n" + std::to_string(i) + std::string(10'000, 'x')}, {0.0}};
        EXPECT_FALSE(joiner.take(message.message(), 0));
    }
    const std::vector<std::string> names = joiner.takeUnknownNames();
    EXPECT_EQ(names.size(), JointStateJoiner::kMostUnknownNames);
    EXPECT_LE(names.front().size(), 256U);
    EXPECT_EQ(joiner.counters().unknown, 3 * JointStateJoiner::kMostUnknownNames);
}

TEST(JointStateJoiner, takesNoPositionThatIsNotFinite) {
    JointStateJoiner joiner({"a", "b"}, 0.1);
    JointMessage good{{"a", "b"}, {1.0, 2.0}};
    JointMessage bad{{"a", "b"}, {1.5, kNaN}};
    ASSERT_TRUE(joiner.take(good.message(), 0));
    // b keeps its last position until it is too old.
    const auto kept = joiner.take(bad.message(), 50 * kMillisecond_ns);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->position, JointVector(1.5, 2.0));
    EXPECT_FALSE(joiner.take(bad.message(), 101 * kMillisecond_ns));
    EXPECT_EQ(joiner.missing(101 * kMillisecond_ns), std::vector<std::size_t>{1});
    EXPECT_EQ(joiner.counters().notFinite, 2U);
    JointMessage infinite{{"b"}, {std::numeric_limits<double>::infinity()}};
    EXPECT_FALSE(joiner.take(infinite.message(), 102 * kMillisecond_ns));
    EXPECT_EQ(joiner.counters().notFinite, 3U);
}

TEST(JointStateJoiner, effortThatIsNotANumberIsNotTold) {
    JointStateJoiner joiner({"a", "b"}, 0.1);
    JointMessage message{{"a", "b"}, {1.0, 2.0}, {0.0, 0.5}, {kNaN, 3.0}};
    const auto joined = joiner.take(message.message(), 0);
    ASSERT_TRUE(joined);
    EXPECT_TRUE(joined->effort.empty());
    EXPECT_EQ(joined->velocity, JointVector(0.0, 0.5));
}

TEST(JointStateJoiner, refusesMessagesThatContradictThemselves) {
    JointStateJoiner joiner({"a", "b"}, 0.1);
    JointMessage tooFew{{"a", "b"}, {1.0}};
    JointMessage tooMany{{"a", "b"}, {1.0, 2.0}, {0.0, 0.0, 0.0}};
    JointMessage effort{{"a", "b"}, {1.0, 2.0}, {}, {1.0}};
    JointMessage twice{{"a", "b", "a"}, {1.0, 2.0, 3.0}};
    for (JointMessage* message : {&tooFew, &tooMany, &effort, &twice})
        EXPECT_FALSE(joiner.take(message->message(), 0));
    EXPECT_EQ(joiner.counters().malformed, 4U);
    EXPECT_EQ(joiner.missing(0).size(), 2U);
}

TEST(JointStateJoiner, emptyMessagesAndThoseWithoutPositionsSayNothing) {
    JointStateJoiner joiner({"a"}, 0.1);
    JointMessage empty{{}, {}};
    JointMessage velocityOnly{{"a"}, {}, {0.5}};
    EXPECT_FALSE(joiner.take(empty.message(), 0));
    EXPECT_FALSE(joiner.take(velocityOnly.message(), 0));
    EXPECT_EQ(joiner.counters().malformed, 0U);
    EXPECT_EQ(joiner.counters().messages, 2U);
}

TEST(JointStateJoiner, countsOddStamps) {
    JointStateJoiner joiner({"a"}, 0.1);
    const std::vector<Time> stamps{{10, 0}, {10, 0}, {10, 1}, {9, 999'999'999}, {0, 0}, {10, 2}};
    for (const Time& stamp : stamps) {
        JointMessage message{{"a"}, {1.0}, {}, {}, stamp};
        EXPECT_TRUE(joiner.take(message.message(), 0));
    }
    EXPECT_EQ(joiner.stamps().zero(), 1U);
    EXPECT_EQ(joiner.stamps().equal(), 1U);
    EXPECT_EQ(joiner.stamps().backward(), 1U);
}

} // namespace
} // namespace teleta::ros
