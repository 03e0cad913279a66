// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_phases.h"
#include "tests/backend/servo/servo_frames.h"

#include <gtest/gtest.h>

#include <limits>

using namespace teleta::servo;
using namespace teleta::servo::test;
using teleta::contact::ContactType;

namespace {

TaskRefusal refusalOf(const ServoTask& task) {
    const auto fine = check(task);
    EXPECT_FALSE(fine.has_value());
    return fine ? TaskRefusal{} : fine.error();
}

/// Feeds one frame for a while and returns the index of the task that runs then.
std::size_t after(ServoPhases& phases, const ServoPlan& plan,
                  const teleta::contact::TactileFeatures& features, double time_s, double path_m = 0.0) {
    const int steps = static_cast<int>(std::lround(time_s / 0.01));
    for (int i = 0; i < steps; ++i)
        phases.update(plan, features, features.alphaZ_rad ? -*features.alphaZ_rad : 0.0, path_m / steps,
                      0.01);
    return phases.index();
}

} // namespace

TEST(ServoTask, theTasksOfThePaperAreGood) {
    for (const ServoPlan& plan :
         {explorePlan(), explorePlan(5.0, 0.005, false), comanipulationPlan(), rollPlan(), pointPlan()})
        EXPECT_TRUE(check(plan).has_value()) << plan.name;
}

TEST(ServoTask, whatIsNotGoodIsRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    ServoTask task = exploreTask(5.0, 0.005);
    task.gains.proportional[kZ] = nan;
    EXPECT_EQ(refusalOf(task), TaskRefusal::notFinite);
    task = exploreTask(5.0, 0.005);
    task.desired.force_N = 31.0;
    EXPECT_EQ(refusalOf(task), TaskRefusal::forceTooHigh);
    task.desired.force_N = -0.1;
    EXPECT_EQ(refusalOf(task), TaskRefusal::forceTooHigh);
    task = exploreTask(5.0, 0.005);
    task.desired.copX_m = 0.0501;
    EXPECT_EQ(refusalOf(task), TaskRefusal::featureOutside);
    task = exploreTask(5.0, 0.005);
    task.gains.proportional[kWy] = 1.001 * highestGain()[kWy];
    EXPECT_EQ(refusalOf(task), TaskRefusal::gainTooHigh);
    task = exploreTask(5.0, 0.005);
    task.limits.toolSpeed_mPerS = 0.0;
    EXPECT_EQ(refusalOf(task), TaskRefusal::badLimit);
    task = exploreTask(5.0, 0.005);
    task.normalCompliance_mPerN = nan;
    EXPECT_EQ(refusalOf(task), TaskRefusal::badLimit);
}

TEST(ServoTask, aPlanNamesOnlyItsOwnTasks) {
    ServoPlan plan = explorePlan();
    plan.tasks[1].next = 5;
    EXPECT_EQ(check(plan).error(), TaskRefusal::badReference);
    EXPECT_EQ(check(ServoPlan{}).error(), TaskRefusal::badReference);
    plan = explorePlan();
    plan.search.probes = 0;
    EXPECT_EQ(check(plan).error(), TaskRefusal::badLimit);
}

TEST(ServoTask, theBaselineLacksOnlyWhatDzmpBrings) {
    const ServoPlan ours = explorePlan();
    const ServoPlan baseline = explorePlan(5.0, 0.005, false);
    EXPECT_FALSE(baseline.tasks[3].projection.wy);
    EXPECT_TRUE(ours.tasks[3].projection.wy);
    EXPECT_TRUE(baseline.tasks[3].projection.x && baseline.tasks[3].projection.y &&
                baseline.tasks[3].projection.z && baseline.tasks[3].projection.wz);
    EXPECT_EQ(baseline.tasks[3].gains.proportional, ours.tasks[3].gains.proportional);
    EXPECT_EQ(baseline.tasks[3].desired.force_N, ours.tasks[3].desired.force_N);
}

TEST(ServoPhases, theFourPhasesFollowEachOtherByWhatIsMeasured) {
    const ServoPlan plan = explorePlan();
    ServoPhases phases(plan);
    EXPECT_EQ(after(phases, plan, nothing(), 20.0), 0U);
    const auto point = feel(ContactType::point, 1.0, 0.02, 0.0, 0.02, 0.0);
    EXPECT_EQ(after(phases, plan, point, 0.01), 1U);
    EXPECT_EQ(after(phases, plan, point, 20.0), 1U);
    const auto askew = feel(ContactType::edge, 5.0, 0.003, 0.002, 0.001, 0.002, 0.1);
    EXPECT_EQ(after(phases, plan, askew, 0.09), 1U);
    EXPECT_EQ(after(phases, plan, askew, 0.02), 2U);
    EXPECT_EQ(after(phases, plan, askew, 20.0), 2U);
    // 0.9 degrees, 0.4 mm, 0.4 mm for 0.2 s.
    const auto aligned = feel(ContactType::edge, 5.0, 0.0014, 0.0004, 0.001, 0.0, 0.0157);
    EXPECT_EQ(after(phases, plan, aligned, 0.19), 2U);
    EXPECT_EQ(after(phases, plan, aligned, 0.02), 3U);
    EXPECT_EQ(after(phases, plan, aligned, 60.0), 3U);
}

TEST(ServoPhases, anInterruptionStartsTheHoldAnew) {
    const ServoPlan plan = explorePlan();
    ServoPhases phases(plan);
    phases.enter(2);
    const auto aligned = feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    const auto off = feel(ContactType::edge, 5.0, 0.0006, 0.0, 0.0, 0.0, 0.0);
    EXPECT_EQ(after(phases, plan, aligned, 0.15), 2U);
    EXPECT_EQ(after(phases, plan, off, 0.01), 2U);
    EXPECT_EQ(after(phases, plan, aligned, 0.15), 2U);
    EXPECT_EQ(after(phases, plan, aligned, 0.06), 3U);
}

TEST(ServoPhases, aShortPointDoesNotLeaveTheEdgeAndALongOneDoes) {
    const ServoPlan plan = explorePlan();
    ServoPhases phases(plan);
    phases.enter(3);
    const auto point = feel(ContactType::point, 5.0, 0.01, 0.0, 0.01, 0.0);
    const auto edge = feel(ContactType::edge, 5.0, 0.01, 0.0, 0.008, 0.0);
    EXPECT_EQ(after(phases, plan, point, 0.49), 3U);
    EXPECT_EQ(after(phases, plan, edge, 0.01), 3U);
    EXPECT_EQ(after(phases, plan, point, 0.49), 3U);
    EXPECT_EQ(after(phases, plan, point, 0.02), 1U);
}

TEST(ServoPhases, aPathOrATimeEndsATaskAndTheLastOneSaysThatItIsDone) {
    ServoPlan plan = explorePlan();
    plan.tasks[3].exit.path_m = 0.1;
    plan.tasks[4].exit.time_s = 1.0;
    ServoPhases phases(plan);
    phases.enter(3);
    const auto edge = feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0);
    EXPECT_EQ(after(phases, plan, edge, 10.0, 0.099), 3U);
    EXPECT_EQ(after(phases, plan, edge, 1.0, 0.002), 4U);
    EXPECT_FALSE(phases.finished());
    EXPECT_EQ(after(phases, plan, edge, 1.01), 4U);
    EXPECT_TRUE(phases.finished());
}

TEST(ServoPhases, aDirectionThatIsNotDefinedIsNotAligned) {
    const ServoPlan plan = explorePlan();
    ServoPhases phases(plan);
    phases.enter(2);
    auto blob = feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0);
    blob.alphaZ_rad.reset();
    EXPECT_EQ(after(phases, plan, blob, 5.0), 2U);
}
