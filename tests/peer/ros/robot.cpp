// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <time.h>

namespace teleta::peer {

namespace {

constexpr double kGain_perS = 20;

std::vector<double> startOf(const RobotOptions& options, const ArmPhysics& arm) {
    if (options.position_rad.empty())
        return std::vector<double>(arm.joints().size(), 0.0);
    if (options.position_rad.size() != arm.joints().size())
        throw std::runtime_error("--position needs " + std::to_string(arm.joints().size()) + " numbers");
    return options.position_rad;
}

nlohmann::json pointsOf(const trajectory_msgs::msg::JointTrajectory& trajectory) {
    nlohmann::json points = nlohmann::json::array();
    for (const auto& point : trajectory.points())
        points.push_back(
            {{"time_s", point.time_from_start().sec() + 1e-9 * point.time_from_start().nanosec()},
             {"positions", point.positions()},
             {"velocities", point.velocities()}});
    return points;
}

/// Each `rate_Hz` of 1000 steps.
bool due(std::int64_t step, double rate_Hz) {
    return step % std::max<std::int64_t>(1, std::llround(1000 / rate_Hz)) == 0;
}

/// The default of MoveIt Servo's incoming_command_timeout.
constexpr double kServoTimeout_s = 0.1;

} // namespace

std::int64_t clock_ns(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

Robot::Robot(const RobotOptions& options, const std::string& urdf)
    : m_options(options)
    , m_arm(urdf, options.tip, options.pad, options.objects)
    , m_follower(m_arm.joints(), startOf(options, m_arm),
                 options.startFrom == "desired" ? TrajectoryFollower::Start::Desired
                                                : TrajectoryFollower::Start::Measured,
                 options.distribution == "jazzy")
    , m_velocityCommand(m_arm.joints().size(), 0.0)
    , m_positionCommand(startOf(options, m_arm))
    , m_topics(options, urdf, m_arm)
    , m_random(options.seed) {
    m_arm.place(startOf(options, m_arm));
    if (!options.log.empty()) {
        m_log.open(options.log);
        if (!m_log)
            throw std::runtime_error("cannot write " + options.log);
    }
    for (const char* count :
         {"steps", "late_steps", "joint_states", "refused_writes", "accepted", "refused", "deaf"})
        m_counts[count] = 0;
    m_counts["latest_ms"] = 0.0;
    log("ready", {{"joints", m_arm.joints()}, {"tip", m_arm.tip()}, {"domain", options.domain}});
}

void Robot::log(const char* event, nlohmann::json fields) {
    if (!m_log.is_open())
        return;
    fields["event"] = event;
    fields["steady_ns"] = clock_ns(CLOCK_MONOTONIC);
    m_log << fields.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void Robot::step(std::int64_t step, double late_s) {
    const double now_s = static_cast<double>(step) * ArmPhysics::kStep_s;
    m_counts["steps"] = step + 1;
    if (late_s > 0.001)
        m_counts["late_steps"] = m_counts["late_steps"].get<int>() + 1;
    m_counts["latest_ms"] = std::max(m_counts["latest_ms"].get<double>(), 1e3 * late_s);
    setFaults(now_s);
    takeCommands(now_s);

    const JointSetpoint desired = m_follower.at(now_s);
    std::vector<double> velocity = m_velocityCommand;
    if (m_options.controller == "trajectory") {
        const std::vector<double> position = m_arm.position_rad();
        for (std::size_t i = 0; i < velocity.size(); ++i)
            velocity[i] = desired.velocity_radPerS[i] + kGain_perS * (desired.position_rad[i] - position[i]);
    }
    if (m_options.controller == "position") {
        const std::vector<double> position = m_arm.position_rad();
        for (std::size_t i = 0; i < velocity.size(); ++i)
            velocity[i] = kGain_perS * (m_positionCommand[i] - position[i]);
    }
    if (m_options.controller == "servo")
        velocity = servoVelocity();
    m_arm.step(velocity);
    tell(step);
    logChanges();
    if (due(step, 100)) {
        nlohmann::json state{{"time_s", now_s},
                             {"position", m_arm.position_rad()},
                             {"velocity", m_arm.velocity_radPerS()},
                             {"desired", desired.position_rad}};
        if (!m_options.objects.empty()) {
            const std::vector<double> taxels_N = m_arm.taxels_N();
            state["pad_N"] = std::accumulate(taxels_N.begin(), taxels_N.end(), 0.0);
            state["depth_m"] = m_arm.depth_m();
        }
        log("state", std::move(state));
    }
    if (due(step, 5))
        m_log.flush();
}

std::vector<double> Robot::servoVelocity() const {
    return 1e-9 * static_cast<double>(clock_ns(CLOCK_REALTIME)) < m_servoUntil_s
               ? m_velocityCommand
               : std::vector<double>(m_velocityCommand.size(), 0.0);
}

void Robot::takeJogs() {
    for (const auto& jog : m_topics.takeJogs()) {
        if (has("deaf"))
            continue;
        const double stamp_s = jog.header().stamp().sec() + 1e-9 * jog.header().stamp().nanosec();
        std::vector<double> velocity(m_velocityCommand.size(), 0.0);
        bool known = jog.joint_names().size() == jog.velocities().size();
        for (std::size_t i = 0; known && i < jog.joint_names().size(); ++i) {
            const auto joint = std::find(m_arm.joints().begin(), m_arm.joints().end(), jog.joint_names()[i]);
            known = joint != m_arm.joints().end();
            if (known)
                velocity[static_cast<std::size_t>(joint - m_arm.joints().begin())] = jog.velocities()[i];
        }
        if (known) {
            m_velocityCommand = velocity;
            m_servoUntil_s = stamp_s + kServoTimeout_s;
        }
        log("jog", {{"accepted", known},
                    {"velocities", jog.velocities()},
                    {"age_s", 1e-9 * static_cast<double>(clock_ns(CLOCK_REALTIME)) - stamp_s}});
    }
}

void Robot::takeCommands(double now_s) {
    takeJogs();
    const auto trajectories = m_topics.takeTrajectories();
    const auto values = m_topics.takeValues();
    if (has("deaf")) {
        m_counts["deaf"] = m_counts["deaf"].get<std::size_t>() + trajectories.size() + values.size();
        return;
    }
    const auto count = [this](bool accepted) {
        const char* name = accepted ? "accepted" : "refused";
        m_counts[name] = m_counts[name].get<int>() + 1;
    };
    for (const auto& trajectory : trajectories) {
        const JointSetpoint measured{m_arm.position_rad(), m_arm.velocity_radPerS()};
        const double wall_s = 1e-9 * static_cast<double>(clock_ns(CLOCK_REALTIME));
        const std::string why = m_follower.accept(trajectory, now_s, wall_s - now_s, measured);
        count(why.empty());
        log("trajectory", {{"accepted", why.empty()},
                           {"reason", why},
                           {"joint_names", trajectory.joint_names()},
                           {"points", pointsOf(trajectory)},
                           {"position", measured.position_rad}});
    }
    std::vector<double>& kept = m_options.controller == "position" ? m_positionCommand : m_velocityCommand;
    for (const auto& message : values) {
        const std::vector<double>& data = message.data();
        const bool whole = data.size() == kept.size();
        if (whole)
            kept = data;
        count(whole);
        log(m_options.controller.c_str(),
            {{"accepted", whole}, {"data", data}, {"position", m_arm.position_rad()}});
    }
}

void Robot::setFaults(double now_s) {
    std::set<std::string> active;
    if (m_commanded != "none")
        active.insert(m_commanded);
    for (const Fault& fault : m_options.faults)
        if (now_s >= fault.start_s && now_s < fault.start_s + fault.duration_s)
            active.insert(fault.kind);
    if (active == m_active)
        return;
    if (active.count("best-effort") != m_active.count("best-effort"))
        m_topics.tellJointsAs(active.count("best-effort") == 0 && m_options.jointQos == "reliable");
    m_active = active;
    log("fault", {{"active", m_active}});
}

void Robot::tell(std::int64_t step) {
    const auto counted = [this](bool written) {
        if (!written)
            m_counts["refused_writes"] = m_counts["refused_writes"].get<int>() + 1;
        return written;
    };
    std::int64_t stamp_ns = clock_ns(CLOCK_REALTIME);
    if (m_options.pad && !has("no-pad") && due(step, m_options.padRate_Hz))
        counted(m_topics.tellPad(m_arm.taxels_N()));
    if (!due(step, m_options.rate_Hz))
        return;
    if (!has("no-wrench"))
        counted(m_topics.tellWrench(m_arm.wrench(), stamp_ns));
    if (has("silent"))
        return;
    JointTelling joints{m_arm.joints(), m_arm.position_rad(), m_arm.velocity_radPerS(),
                        m_options.torqueSensors ? m_arm.sensorTorque_Nm()
                                                : m_arm.effort_Nm(m_options.effortWithGravity)};
    addNoise(joints.position_rad, m_options.positionNoise_rad);
    addNoise(joints.effort_Nm, m_options.effortNoise_Nm);
    if (has("nan"))
        joints.position_rad.front() = std::numeric_limits<double>::quiet_NaN();
    if (has("infinite"))
        joints.velocity_radPerS.front() = std::numeric_limits<double>::infinity();
    if (has("jump"))
        joints.position_rad.front() += 0.5;
    if (has("missing")) {
        joints.name.pop_back();
        for (std::vector<double>* values :
             {&joints.position_rad, &joints.velocity_radPerS, &joints.effort_Nm})
            values->pop_back();
    }
    if (has("swapped")) {
        std::reverse(joints.name.begin(), joints.name.end());
        for (std::vector<double>* values :
             {&joints.position_rad, &joints.velocity_radPerS, &joints.effort_Nm})
            std::reverse(values->begin(), values->end());
    }
    if (has("backward"))
        stamp_ns -= 2'000'000'000;
    if (has("zero-stamp"))
        stamp_ns = 0;
    if (m_options.frames)
        counted(m_topics.tellFrames(m_arm.movingFrames(), stamp_ns));
    if (counted(m_topics.tellJoints(joints, stamp_ns)))
        m_counts["joint_states"] = m_counts["joint_states"].get<int>() + 1;
}

void Robot::addNoise(std::vector<double>& values, double sd) {
    if (!(sd > 0))
        return;
    for (double& value : values)
        value += sd * m_noise(m_random);
}

void Robot::logChanges() {
    const int commanders = m_topics.commanders();
    const int readers = m_topics.jointReaders();
    const int incompatible = m_topics.incompatible();
    if (commanders == m_commanders && readers == m_jointReaders && incompatible == m_incompatible)
        return;
    m_commanders = commanders;
    m_jointReaders = readers;
    m_incompatible = incompatible;
    log("matched", {{"commanders", commanders}, {"joint_readers", readers}, {"incompatible", incompatible}});
}

std::string Robot::command(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    if (verb == "fault") {
        std::string kind;
        words >> kind;
        const auto& kinds = faultKinds();
        if (kind != "none" && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            return "error no fault " + kind;
        m_commanded = kind;
        return "done";
    }
    if (verb == "counts")
        return "done " + m_counts.dump();
    std::array<double, 3> force_N{};
    if (verb == "push" && words >> force_N[0] >> force_N[1] >> force_N[2]) {
        m_arm.push(force_N);
        return "done";
    }
    if (verb == "press" && m_options.pad && m_options.objects.empty() && words >> force_N[0] &&
        force_N[0] >= 0) {
        m_arm.press(force_N[0]);
        return "done";
    }
    return "error expected: fault KIND | push FX FY FZ | press F (with --pad) | counts";
}

void Robot::finish() {
    log("end", m_counts);
    m_log.flush();
}

} // namespace teleta::peer
