// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "messages.h"

#include <string>
#include <vector>

namespace teleta::peer {

struct JointSetpoint {
    std::vector<double> position_rad;
    std::vector<double> velocity_radPerS;
};

/// A simplified JointTrajectoryController. A new trajectory replaces the one that runs, from where the arm is
/// measured (Humble) or from the setpoint of this moment (Jazzy with interpolate_from_desired_state). Between
/// points: cubic where both ends have velocities, else linear; accelerations and efforts are not used. After
/// the last point it holds. Times are those of one steady clock in seconds. Thread: one at a time.
class TrajectoryFollower {
public:
    enum class Start { Measured, Desired };

    /// Jazzy refuses points without positions and ends that are not at rest; Humble takes both.
    TrajectoryFollower(std::vector<std::string> joints, std::vector<double> position_rad, Start start,
                       bool strict);

    /// Empty when it is followed, else why not; then what ran goes on. `wallMinusSteady_s` turns a stamp into
    /// this clock.
    std::string accept(const trajectory_msgs::msg::JointTrajectory& trajectory, double now_s,
                       double wallMinusSteady_s, const JointSetpoint& measured);
    [[nodiscard]] JointSetpoint at(double time_s) const;

private:
    struct Point {
        double time_s = 0;
        std::vector<double> position_rad;
        std::vector<double> velocity_radPerS; ///< or empty
    };
    [[nodiscard]] std::string refusal(const trajectory_msgs::msg::JointTrajectory& trajectory) const;

    std::vector<std::string> m_joints;
    Start m_start;
    bool m_strict;
    std::vector<Point> m_points;
};

} // namespace teleta::peer
