// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_history.h"

#include <gtest/gtest.h>

namespace teleta::pipeline {

namespace {

TouchRecord heardAt(double start_s, double ready_s, double x_m, std::int64_t ready_ns = 1) {
    TouchRecord touch;
    touch.start_s = start_s;
    touch.ready_s = ready_s;
    touch.ready_ns = ready_ns;
    touch.located = true;
    touch.p_Base_Contact_m = {x_m, 0.0, -0.3};
    return touch;
}

using Kind = TouchHistory::Kind;

} // namespace

TEST(TouchHistory, knowsATouchThatIsPlayedAgain) {
    TouchHistory history;
    TouchRecord one = heardAt(1.0, 2.0, 0.0);
    TouchRecord two = heardAt(2.0, 3.0, 0.2); // begins when the other one was ready
    EXPECT_EQ(history.add(one), Kind::first);
    EXPECT_EQ(history.add(two), Kind::first);
    EXPECT_EQ(one.number, 1U);
    EXPECT_EQ(two.number, 2U);
    TouchRecord again = heardAt(1.0, 2.0, 0.001, 77);
    again.arrived_ns = 79;
    EXPECT_EQ(history.add(again), Kind::again);
    EXPECT_EQ(again.number, 1U);
    EXPECT_EQ(again.ready_ns, 77);
    EXPECT_EQ(again.arrived_ns, 79);
    EXPECT_EQ(again.p_Base_Contact_m.x(), 0.0);
    FoundObjects objects;
    history.fill(objects);
    ASSERT_EQ(objects.objects().size(), 2U);
    EXPECT_EQ(objects.objects()[0].touches, 1U);
}

TEST(TouchHistory, replacesATouchThatAJumpHadCutOff) {
    TouchHistory history;
    TouchRecord cut = heardAt(1.5, 2.0, 0.01);
    TouchRecord whole = heardAt(1.0, 2.0, 0.0);
    EXPECT_EQ(history.add(cut), Kind::first);
    EXPECT_EQ(history.add(whole), Kind::better);
    EXPECT_EQ(whole.number, 1U);
    TouchRecord cutAgain = heardAt(1.5, 2.0, 0.01);
    EXPECT_EQ(history.add(cutAgain), Kind::again);
    EXPECT_EQ(cutAgain.p_Base_Contact_m.x(), 0.0);
    FoundObjects objects;
    history.fill(objects);
    ASSERT_EQ(objects.objects().size(), 1U);
    EXPECT_EQ(objects.objects()[0].touches, 1U);
    EXPECT_EQ(objects.objects()[0].p_Base_Centre_m.x(), 0.0);
}

TEST(TouchHistory, replacesWhatWasEvaluatedWithOtherSettingsUnlessItIsCutOff) {
    TouchHistory history;
    TouchRecord old = heardAt(1.0, 2.0, 0.0);
    EXPECT_EQ(history.add(old), Kind::first);
    history.settingsChanged();
    TouchRecord cut = heardAt(1.5, 2.0, 0.01);
    EXPECT_EQ(history.add(cut), Kind::again);
    TouchRecord fresh = heardAt(1.0, 2.0, 0.02);
    EXPECT_EQ(history.add(fresh), Kind::better);
    TouchRecord again = heardAt(1.0, 2.0, 0.02);
    EXPECT_EQ(history.add(again), Kind::again);
}

TEST(TouchHistory, remembersWhereAnotherObjectBegan) {
    TouchHistory history;
    TouchRecord one = heardAt(1.0, 2.0, 0.0);
    TouchRecord two = heardAt(3.0, 4.0, 0.001);
    TouchRecord three = heardAt(5.0, 6.0, 0.002);
    history.add(one);
    history.closeObject();
    history.add(two);
    history.add(three);
    FoundObjects objects;
    history.fill(objects);
    ASSERT_EQ(objects.objects().size(), 2U);
    EXPECT_EQ(objects.objects()[0].touches, 1U);
    EXPECT_EQ(objects.objects()[1].touches, 2U);
}

} // namespace teleta::pipeline
