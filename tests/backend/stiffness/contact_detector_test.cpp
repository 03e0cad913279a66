// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/contact_detector.h"

#include <gtest/gtest.h>

#include <limits>

using namespace teleta::stiffness;

namespace {

JointSample torqueAt(double time_s, double torque_Nm) {
    return {time_s, 0.001 * time_s, torque_Nm};
}

} // namespace

TEST(ContactDetector, findsTheContactAboveTheThresholdAndRecordsFromTheNoiseFloor) {
    ContactDetector detector;
    const double torques_Nm[] = {0.0, 0.001, -0.002, 0.003, 0.02, 0.05, 0.051};
    const ContactPhase expected[] = {
        ContactPhase::free,       ContactPhase::free,       ContactPhase::free,   ContactPhase::transition,
        ContactPhase::transition, ContactPhase::transition, ContactPhase::contact};
    for (std::size_t i = 0; i < std::size(torques_Nm); ++i)
        EXPECT_EQ(detector.update(torqueAt(0.001 * static_cast<double>(i), torques_Nm[i])), expected[i]) << i;
    ASSERT_EQ(detector.transition().size(), 4U);
    EXPECT_EQ(detector.transition().front().torque_Nm, 0.003);
    EXPECT_EQ(detector.transition().back().torque_Nm, 0.051);
}

TEST(ContactDetector, measuresAgainstTheReference) {
    ContactDetector detector;
    EXPECT_EQ(detector.update(torqueAt(0.0, 1.2), 1.2), ContactPhase::free);
    EXPECT_EQ(detector.update(torqueAt(0.1, 1.3), 1.3), ContactPhase::free)
        << "the reference moves with gravity";
    EXPECT_EQ(detector.update(torqueAt(0.2, 1.36), 1.3), ContactPhase::contact);
    EXPECT_NEAR(detector.transition().back().torque_Nm, 0.06, 1e-12);
}

TEST(ContactDetector, aTouchFromTheOtherSideIsAContactToo) {
    ContactDetector detector;
    EXPECT_EQ(detector.update(torqueAt(0.0, -0.02)), ContactPhase::transition);
    EXPECT_EQ(detector.update(torqueAt(0.1, -0.06)), ContactPhase::contact);
}

TEST(ContactDetector, aRiseThatFallsBackWasNone) {
    ContactDetector detector;
    detector.update(torqueAt(0.0, 0.004));
    EXPECT_EQ(detector.update(torqueAt(0.1, 0.0015)), ContactPhase::transition)
        << "over half the noise floor";
    EXPECT_EQ(detector.update(torqueAt(0.2, 0.001)), ContactPhase::free);
    detector.update(torqueAt(0.3, 0.03));
    ASSERT_EQ(detector.transition().size(), 1U);
    EXPECT_EQ(detector.transition().front().time_s, 0.3);
}

TEST(ContactDetector, contactEndsBelowHalfTheNoiseFloorAndItsTransitionStaysToBeRead) {
    ContactDetector detector;
    detector.update(torqueAt(0.0, 0.06));
    EXPECT_EQ(detector.update(torqueAt(0.1, 0.01)), ContactPhase::contact);
    EXPECT_EQ(detector.update(torqueAt(0.2, 0.0)), ContactPhase::free);
    EXPECT_EQ(detector.transition().size(), 2U);
}

TEST(ContactDetector, leavesOutAndCountsWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    ContactDetector detector;
    detector.update(torqueAt(0.0, 0.06));
    EXPECT_EQ(detector.update(torqueAt(0.1, nan)), ContactPhase::contact);
    EXPECT_EQ(detector.update(torqueAt(0.2, infinity)), ContactPhase::contact);
    EXPECT_EQ(detector.update(torqueAt(0.3, 0.06), nan), ContactPhase::contact);
    EXPECT_EQ(detector.samplesLeftOut(), 3U);
    EXPECT_EQ(detector.transition().size(), 1U);
    detector.reset();
    EXPECT_EQ(detector.samplesLeftOut(), 0U);
    EXPECT_EQ(detector.phase(), ContactPhase::free);
}

TEST(ContactDetector, keepsNoMoreThanItsCapacityAndCountsTheRest) {
    DetectionSettings settings;
    settings.capacity = 3;
    ContactDetector detector(settings);
    for (int i = 0; i < 10; ++i)
        detector.update(torqueAt(0.1 * i, 0.06));
    EXPECT_EQ(detector.transition().size(), 3U);
    EXPECT_EQ(detector.samplesBeyondCapacity(), 7U);
}

TEST(ContactDetector, settingsThatMakeNoSenseStillDetect) {
    DetectionSettings settings;
    settings.noiseFloor_Nm = -1.0;
    settings.threshold_Nm = std::numeric_limits<double>::quiet_NaN();
    ContactDetector detector(settings);
    EXPECT_EQ(detector.update(torqueAt(0.0, 0.0)), ContactPhase::free);
    EXPECT_EQ(detector.update(torqueAt(0.1, 0.001)), ContactPhase::contact);
}
