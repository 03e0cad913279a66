// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote/remote_stream.h"

#include <gtest/gtest.h>

namespace teleta::site_link {
namespace {

constexpr site::BootName kFirst{1};
constexpr site::BootName kSecond{2};

TEST(RemoteStream, beginsWhereItIsFirstHeard) {
    RemoteStream stream;
    const RemoteStream::Step step = stream.take(kFirst, 100, 4);
    EXPECT_TRUE(step.use);
    EXPECT_EQ(step.lost, 0U);
    EXPECT_FALSE(step.discontinuity);
}

TEST(RemoteStream, countsWhatNeverCame) {
    RemoteStream stream;
    (void)stream.take(kFirst, 0, 4);
    EXPECT_EQ(stream.take(kFirst, 10, 2).lost, 6U);
    EXPECT_EQ(stream.take(kFirst, 12, 1).lost, 0U);
}

TEST(RemoteStream, knowsWhatTheSiteHadLostBefore) {
    RemoteStream stream;
    EXPECT_EQ(stream.take(kFirst, 100, 4, 30).atSite, 0U) << "before it was heard";
    const RemoteStream::Step both = stream.take(kFirst, 110, 2, 34);
    EXPECT_EQ(both.lost, 6U);
    EXPECT_EQ(both.atSite, 4U);
    EXPECT_EQ(stream.take(kFirst, 113, 2, 34).atSite, 0U);
    EXPECT_EQ(stream.take(kSecond, 5, 1, 7).atSite, 0U) << "the site was started anew";
    EXPECT_EQ(stream.take(kSecond, 8, 1, 9).atSite, 2U);
}

TEST(RemoteStream, theSitesNumberOfLossesBeginsAgainAfter32Bits) {
    RemoteStream stream;
    (void)stream.take(kFirst, 0, 1, 0xFFFF'FFFEU);
    EXPECT_EQ(stream.take(kFirst, 6, 1, 3).atSite, 5U);
}

TEST(RemoteStream, ignoresWhatComesTwiceOrWasOvertaken) {
    RemoteStream stream;
    (void)stream.take(kFirst, 0, 4);
    (void)stream.take(kFirst, 8, 4);
    EXPECT_FALSE(stream.take(kFirst, 8, 4).use);
    EXPECT_FALSE(stream.take(kFirst, 4, 4).use);
    EXPECT_FALSE(stream.take(kFirst, 12, 0).use);
    EXPECT_TRUE(stream.take(kFirst, 12, 4).use);
}

TEST(RemoteStream, aSiteThatWasStartedAnewBeginsAnewAndLosesNothing) {
    RemoteStream stream;
    (void)stream.take(kFirst, 1000, 4);
    const RemoteStream::Step step = stream.take(kSecond, 0, 4);
    EXPECT_TRUE(step.use);
    EXPECT_TRUE(step.discontinuity);
    EXPECT_EQ(step.lost, 0U);
}

TEST(RemoteStream, timesNeverGoBack) {
    RemoteStream stream;
    EXPECT_EQ(stream.inOrder(10), 10);
    EXPECT_EQ(stream.inOrder(5), 10);
    EXPECT_EQ(stream.inOrder(11), 11);
}

} // namespace
} // namespace teleta::site_link
