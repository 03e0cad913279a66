// SPDX-License-Identifier: GPL-3.0-or-later
#include "trajectory_follower.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace teleta::peer {

namespace {

double seconds(std::int32_t sec, std::uint32_t nanosec) {
    return sec + 1e-9 * nanosec;
}

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

} // namespace

TrajectoryFollower::TrajectoryFollower(std::vector<std::string> joints, std::vector<double> position_rad,
                                       Start start, bool strict)
    : m_joints(std::move(joints))
    , m_start(start)
    , m_strict(strict) {
    m_points.push_back({0, std::move(position_rad), std::vector<double>(m_joints.size(), 0.0)});
}

std::string TrajectoryFollower::refusal(const trajectory_msgs::msg::JointTrajectory& trajectory) const {
    const std::vector<std::string>& names = trajectory.joint_names();
    if (trajectory.points().empty())
        return "no points";
    for (const std::string& joint : m_joints)
        if (std::count(names.begin(), names.end(), joint) != 1)
            return "joint " + joint + " is not named once";
    if (names.size() != m_joints.size())
        return "joints that the controller does not have";
    double last_s = -1;
    for (const auto& point : trajectory.points()) {
        const double time_s = seconds(point.time_from_start().sec(), point.time_from_start().nanosec());
        if (!(time_s > last_s))
            return "times do not increase";
        last_s = time_s;
        if (point.positions().empty() && (m_strict || point.velocities().empty()))
            return "a point without positions";
        for (const std::vector<double>* values :
             {&point.positions(), &point.velocities(), &point.accelerations()})
            if (!values->empty() && values->size() != names.size())
                return "a point of another number of joints";
        if (!finite(point.positions()) || !finite(point.velocities()))
            return "a number that is not finite";
    }
    const std::vector<double>& end = trajectory.points().back().velocities();
    if (m_strict && std::any_of(end.begin(), end.end(), [](double v) { return std::abs(v) > 1e-6; }))
        return "the end is not at rest";
    return {};
}

std::string TrajectoryFollower::accept(const trajectory_msgs::msg::JointTrajectory& trajectory, double now_s,
                                       double wallMinusSteady_s, const JointSetpoint& measured) {
    if (std::string why = refusal(trajectory); !why.empty())
        return why;
    const double stamp_s = seconds(trajectory.header().stamp().sec(), trajectory.header().stamp().nanosec());
    const double start_s = stamp_s == 0 ? now_s : stamp_s - wallMinusSteady_s;
    const JointSetpoint from = m_start == Start::Measured ? measured : at(now_s);
    std::vector<Point> points{{now_s, from.position_rad, from.velocity_radPerS}};
    for (const auto& given : trajectory.points()) {
        Point point;
        point.time_s = start_s + seconds(given.time_from_start().sec(), given.time_from_start().nanosec());
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            const auto& names = trajectory.joint_names();
            const auto place =
                static_cast<std::size_t>(std::find(names.begin(), names.end(), m_joints[i]) - names.begin());
            if (!given.velocities().empty())
                point.velocity_radPerS.push_back(given.velocities()[place]);
            // Without positions, where the velocity leads to.
            const Point& before = points.back();
            point.position_rad.push_back(given.positions().empty()
                                             ? before.position_rad[i] +
                                                   given.velocities()[place] * (point.time_s - before.time_s)
                                             : given.positions()[place]);
        }
        if (point.time_s > now_s)
            points.push_back(std::move(point));
    }
    if (points.size() == 1)
        return "it ended before now";
    m_points = std::move(points);
    return {};
}

JointSetpoint TrajectoryFollower::at(double time_s) const {
    const auto next =
        std::find_if(m_points.begin(), m_points.end(), [&](const Point& p) { return p.time_s > time_s; });
    const std::size_t joints = m_joints.size();
    if (next == m_points.begin() || next == m_points.end())
        return {(next == m_points.end() ? m_points.back() : *next).position_rad,
                std::vector<double>(joints, 0.0)};
    const Point& a = *std::prev(next);
    const Point& b = *next;
    const double length_s = b.time_s - a.time_s;
    const double s = (time_s - a.time_s) / length_s;
    const bool cubic = !a.velocity_radPerS.empty() && !b.velocity_radPerS.empty();
    JointSetpoint result;
    for (std::size_t i = 0; i < joints; ++i) {
        const double way = b.position_rad[i] - a.position_rad[i];
        if (!cubic) {
            result.position_rad.push_back(a.position_rad[i] + s * way);
            result.velocity_radPerS.push_back(way / length_s);
            continue;
        }
        const double va = a.velocity_radPerS[i] * length_s;
        const double vb = b.velocity_radPerS[i] * length_s;
        const double c2 = 3 * way - 2 * va - vb;
        const double c3 = -2 * way + va + vb;
        result.position_rad.push_back(a.position_rad[i] + s * (va + s * (c2 + s * c3)));
        result.velocity_radPerS.push_back((va + s * (2 * c2 + s * 3 * c3)) / length_s);
    }
    return result;
}

} // namespace teleta::peer
