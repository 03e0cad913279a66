// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arm_physics.h"
#include "robot_options.h"
#include "robot_topics.h"
#include "trajectory_follower.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <random>
#include <set>
#include <string>

namespace teleta::peer {

/// Arm, controller, topics, faults and log, one step of 1 ms at a time.
/// The controller gives the servos v = v_desired + 20/s (q_desired - q). Thread: one at a time.
class Robot {
public:
    Robot(const RobotOptions& options, const std::string& urdf);

    /// The step number `step` (from 0). `late_s`: how much after
    /// its time it begins.
    void step(std::int64_t step, double late_s);
    /// A line of standard input; the answer.
    std::string command(const std::string& line);
    /// Writes the counts and what the log still holds.
    void finish();

private:
    void takeCommands(double now_s);
    void takeJogs();
    /// The servo's velocity; zero without a fresh command.
    [[nodiscard]] std::vector<double> servoVelocity() const;
    void setFaults(double now_s);
    [[nodiscard]] bool has(const std::string& fault) const { return m_active.count(fault) != 0; }
    void tell(std::int64_t step);
    void log(const char* event, nlohmann::json fields);
    void logChanges();
    void addNoise(std::vector<double>& values, double sd);

    RobotOptions m_options;
    ArmPhysics m_arm;
    TrajectoryFollower m_follower;
    std::vector<double> m_velocityCommand;
    std::vector<double> m_positionCommand; ///< as long as nobody commands: where it started
    double m_servoUntil_s = 0;             ///< wall clock; the servo halts then
    RobotTopics m_topics;
    std::ofstream m_log;
    std::set<std::string> m_active;
    std::string m_commanded = "none"; ///< the fault that a line asked for
    int m_commanders = 0;
    int m_jointReaders = 0;
    int m_incompatible = 0;
    nlohmann::json m_counts;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_noise;
};

/// A clock of the machine in ns.
[[nodiscard]] std::int64_t clock_ns(clockid_t clock);

} // namespace teleta::peer
