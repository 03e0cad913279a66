// SPDX-License-Identifier: GPL-3.0-or-later
#include "trajectory_follower.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace teleta::peer;
using trajectory_msgs::msg::JointTrajectory;

namespace {

void add(JointTrajectory& trajectory, double time_s, std::vector<double> position,
         std::vector<double> velocity) {
    trajectory_msgs::msg::JointTrajectoryPoint point;
    point.positions(position);
    point.velocities(velocity);
    point.time_from_start().sec(static_cast<std::int32_t>(time_s));
    point.time_from_start().nanosec(
        static_cast<std::uint32_t>(1e9 * (time_s - static_cast<int>(time_s)) + 0.5));
    trajectory.points().push_back(point);
}

JointTrajectory empty() {
    JointTrajectory trajectory;
    trajectory.joint_names({"b", "a"});
    return trajectory;
}

const JointSetpoint kMeasured{{0.5, 0}, {0, 0}};

} // namespace

TEST(TrajectoryFollower, goesByACubicBetweenPointsWithVelocities) {
    TrajectoryFollower follower({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, true);
    JointTrajectory trajectory = empty();
    add(trajectory, 2, {1, 4}, {0, 0}); // b, a
    EXPECT_EQ(follower.accept(trajectory, 10, 0, kMeasured), "");
    // From rest to rest: 3 s^2 - 2 s^3 of the way.
    EXPECT_NEAR(follower.at(10.5).position_rad[0], 4 * (3.0 / 16 - 2.0 / 64), 1e-12);
    EXPECT_NEAR(follower.at(11).velocity_radPerS[0], 1.5 * 4 / 2, 1e-12);
    EXPECT_NEAR(follower.at(11).position_rad[1], 0.5, 1e-12);
    EXPECT_EQ(follower.at(13).position_rad, (std::vector<double>{4, 1}));
    EXPECT_EQ(follower.at(13).velocity_radPerS, (std::vector<double>{0, 0}));
}

TEST(TrajectoryFollower, goesStraightWithoutVelocities) {
    TrajectoryFollower follower({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, true);
    JointTrajectory trajectory = empty();
    add(trajectory, 1, {1, 2}, {});
    EXPECT_EQ(follower.accept(trajectory, 0, 0, kMeasured), "");
    EXPECT_NEAR(follower.at(0.25).position_rad[0], 0.5, 1e-12);
    EXPECT_NEAR(follower.at(0.25).velocity_radPerS[0], 2, 1e-12);
}

TEST(TrajectoryFollower, startsWhereItIsMeasuredOrFromItsSetpoint) {
    JointTrajectory trajectory = empty();
    add(trajectory, 1, {0, 1}, {});
    TrajectoryFollower measured({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Measured, true);
    EXPECT_EQ(measured.accept(trajectory, 0, 0, kMeasured), "");
    EXPECT_NEAR(measured.at(0.5).position_rad[0], 0.75, 1e-12);
    TrajectoryFollower desired({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, true);
    EXPECT_EQ(desired.accept(trajectory, 0, 0, kMeasured), "");
    EXPECT_NEAR(desired.at(0.5).position_rad[0], 0.5, 1e-12);
}

TEST(TrajectoryFollower, takesAStampAsTheStart) {
    TrajectoryFollower follower({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, true);
    JointTrajectory trajectory = empty();
    add(trajectory, 1, {0, 1}, {});
    trajectory.header().stamp().sec(1000);
    EXPECT_EQ(follower.accept(trajectory, 5, 997, kMeasured), "it ended before now"); // 3 s + 1 s
    EXPECT_EQ(follower.accept(trajectory, 3.5, 997, kMeasured), "");
    EXPECT_NEAR(follower.at(3.75).position_rad[0], 0.5, 1e-12); // 0.5 s are left of it
}

TEST(TrajectoryFollower, refusesWhatTheDistributionRefuses) {
    TrajectoryFollower jazzy({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, true);
    TrajectoryFollower humble({"a", "b"}, {0, 0}, TrajectoryFollower::Start::Desired, false);
    JointTrajectory moving = empty();
    add(moving, 1, {0, 1}, {0, 1});
    EXPECT_EQ(jazzy.accept(moving, 0, 0, kMeasured), "the end is not at rest");
    EXPECT_EQ(humble.accept(moving, 0, 0, kMeasured), "");
    JointTrajectory rates = empty();
    add(rates, 1, {}, {0, 0});
    EXPECT_EQ(jazzy.accept(rates, 0, 0, kMeasured), "a point without positions");
    EXPECT_EQ(humble.accept(rates, 0, 0, kMeasured), "");

    JointTrajectory back = empty();
    add(back, 1, {0, 1}, {});
    add(back, 1, {0, 1}, {});
    EXPECT_EQ(humble.accept(back, 0, 0, kMeasured), "times do not increase");
    JointTrajectory twice = empty();
    twice.joint_names({"a", "a"});
    add(twice, 1, {0, 1}, {});
    EXPECT_EQ(humble.accept(twice, 0, 0, kMeasured), "joint a is not named once");
    JointTrajectory more = empty();
    more.joint_names({"a", "b", "c"});
    add(more, 1, {0, 1, 2}, {});
    EXPECT_EQ(humble.accept(more, 0, 0, kMeasured), "joints that the controller does not have");
    JointTrajectory endless = empty();
    add(endless, 1, {0, HUGE_VAL}, {});
    EXPECT_EQ(humble.accept(endless, 0, 0, kMeasured), "a number that is not finite");
    EXPECT_EQ(humble.accept(empty(), 0, 0, kMeasured), "no points");
}
