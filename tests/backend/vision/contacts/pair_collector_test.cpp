// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/pair_collector.h"

#include <gtest/gtest.h>

#include <vector>

namespace teleta::vision {
namespace {

using Phase = PairCollector::Phase;

CameraContact touch(double u_px, double depth_m) {
    CameraContact contact;
    contact.located = true;
    contact.centre_px = {u_px, 100.0};
    contact.p_Sensor_Centre_m = {0.0, 0.025, 0.05};
    contact.depth_m = depth_m;
    return contact;
}

/// At 10 frames a second.
class PairCollectorTest : public testing::Test {
protected:
    std::optional<Eigen::Vector2d> next(const std::vector<CameraContact>& contacts) {
        return m_collector.next(contacts, 0.1 * m_frame++);
    }
    PairCollector m_collector;
    int m_frame = 0;
};

} // namespace

TEST_F(PairCollectorTest, takesTheMeanPixelOnceATouchWasSteadyForAWhile) {
    EXPECT_EQ(m_collector.phase(), Phase::free);
    EXPECT_FALSE(next({touch(10.0, 0.001)}));
    EXPECT_FALSE(next({touch(10.4, 0.001)}));
    EXPECT_EQ(m_collector.phase(), Phase::touching);
    EXPECT_NEAR(m_collector.progress(), 1.0 / 3.0, 1e-6);
    EXPECT_FALSE(next({touch(10.8, 0.001)}));
    const auto pixel = next({touch(11.2, 0.001)});
    ASSERT_TRUE(pixel);
    EXPECT_DOUBLE_EQ(pixel->x(), 10.6);
    EXPECT_EQ(m_collector.phase(), Phase::taken);
}

TEST_F(PairCollectorTest, takesNoSecondPixelBeforeTheProbeWasLifted) {
    int taken = 0;
    for (int i = 0; i < 20; ++i)
        taken += next({touch(10.0, 0.001)}) ? 1 : 0;
    EXPECT_EQ(taken, 1);
    // Traces of dots that were not found again are not a touch.
    EXPECT_FALSE(next({touch(300.0, 0.00003)}));
    EXPECT_EQ(m_collector.phase(), Phase::free);
    for (int i = 0; i < 20; ++i)
        taken += next({touch(50.0, 0.001)}) ? 1 : 0;
    EXPECT_EQ(taken, 2);
}

TEST_F(PairCollectorTest, waitsWhileTheProbeComesDownOrSlides) {
    for (int i = 1; i <= 10; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.0003 * i)})) << i; // deeper and deeper
    for (int i = 1; i <= 10; ++i)
        EXPECT_FALSE(next({touch(10.0 + 2.0 * i, 0.003)})) << i; // along the skin
    EXPECT_FALSE(next({touch(30.0, 0.003)}));
    EXPECT_FALSE(next({touch(30.0, 0.003)}));
    EXPECT_TRUE(next({touch(30.0, 0.003)}));
}

TEST_F(PairCollectorTest, takesNeitherALightTouchNorOneThatIsNotAlone) {
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.0001)}));
    EXPECT_EQ(m_collector.phase(), Phase::touching);
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.001), touch(300.0, 0.0008)}));
    EXPECT_EQ(m_collector.phase(), Phase::several);
    // A shallow false contact next to it does no harm in either order.
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(next({touch(300.0, 0.0002), touch(10.0, 0.001)}));
    const auto pixel = next({touch(300.0, 0.0002), touch(10.0, 0.001)});
    ASSERT_TRUE(pixel);
    EXPECT_DOUBLE_EQ(pixel->x(), 10.0);
}

TEST_F(PairCollectorTest, aFrameThatCannotBeUsedBeginsTheWaitAnew) {
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.001)}));
    m_collector.skip();
    EXPECT_EQ(m_collector.progress(), 0.0);
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.001)}));
    EXPECT_TRUE(next({touch(10.0, 0.001)}));
}

TEST_F(PairCollectorTest, aTouchThatGoesOnWhereALiftIsAwaitedDoesNotCount) {
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.001)}));
    m_collector.awaitLift();
    EXPECT_EQ(m_collector.phase(), Phase::refused);
    EXPECT_EQ(m_collector.progress(), 0.0);
    for (int i = 0; i < 20; ++i)
        EXPECT_FALSE(next({touch(10.0, 0.001)}));
    EXPECT_EQ(m_collector.phase(), Phase::refused);
    EXPECT_FALSE(next({}));
    EXPECT_EQ(m_collector.phase(), Phase::free);
    for (int i = 0; i < 3; ++i)
        EXPECT_FALSE(next({touch(50.0, 0.001)}));
    const auto pixel = next({touch(50.0, 0.001)});
    ASSERT_TRUE(pixel);
    EXPECT_DOUBLE_EQ(pixel->x(), 50.0);
}

TEST_F(PairCollectorTest, passesOverContactsWithoutAPlace) {
    CameraContact nowhere = touch(10.0, 0.001);
    nowhere.located = false;
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(next({nowhere}));
    EXPECT_EQ(m_collector.phase(), Phase::free);
}

} // namespace teleta::vision
