// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_task.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::servo {

namespace {

/// The paper's pseudo-measurement of CoP_x that makes the sensor slide.
constexpr double kSlideCopX_m = -0.025;
/// Largest distance from the centre of the sensor at which a feature can be.
constexpr double kFarthestFeature_m = 0.050;
constexpr double kRadPerDegree = std::numbers::pi / 180.0;

Vector6 vector(double x, double y, double z, double wx, double wy, double wz) {
    Vector6 v;
    v << x, y, z, wx, wy, wz;
    return v;
}

bool positive(double value) {
    return value > 0.0 && std::isfinite(value);
}

bool notNegative(double value) {
    return value >= 0.0 && std::isfinite(value);
}

bool notNegative(const std::optional<double>& value) {
    return !value || notNegative(*value);
}

/// Settings common to all tasks with contact: the force, and the contact centred along the sensor's y.
ServoTask contactTask(TaskKind kind, double force_N) {
    ServoTask task;
    task.kind = kind;
    task.projection.y = true;
    task.projection.z = true;
    task.desired.force_N = force_N;
    task.gains.proportional = vector(0.0, -3.0, 3.0, 0.0, 0.0, 0.0);
    task.gains.integral = vector(0.0, -0.5, 1.5, 0.0, 0.0, 0.0);
    task.gains.integralLimit = vector(0.01, 0.01, 0.01, 0.05, 0.05, 0.05);
    return task;
}

/// A plan of tasks that follow each other.
ServoPlan sequence(const char* name, std::vector<ServoTask> tasks) {
    for (std::size_t i = 0; i + 1 < tasks.size(); ++i)
        tasks[i].next = i + 1;
    return {.name = name, .tasks = std::move(tasks), .search = {}};
}

} // namespace

const char* toString(TaskKind kind) {
    constexpr std::array kNames{"free_motion", "align",           "edge_control",  "explore",
                                "roll",        "point_following", "comanipulation"};
    return kNames[static_cast<std::size_t>(kind)];
}

Vector6 highestGain() {
    return vector(20.0, 20.0, 20.0, 100.0, 100.0, 20.0);
}

tl::expected<void, TaskRefusal> check(const ServoTask& task) {
    const DesiredFeatures& desired = task.desired;
    const Vector6 s_d = vector(desired.copX_m, desired.copY_m, desired.force_N, desired.wx_m, desired.wy_m,
                               desired.alphaZ_rad);
    for (const Vector6& values : {s_d, task.gains.proportional, task.gains.integral, task.gains.integralLimit,
                                  task.feedForward.constant_Sensor, task.feedForward.sway_Sensor})
        if (!values.array().isFinite().all())
            return tl::unexpected(TaskRefusal::notFinite);

    const ServoLimits& limits = task.limits;
    const ExitCondition& exit = task.exit;
    if (!positive(limits.toolSpeed_mPerS) || !positive(limits.turnRate_radPerS) ||
        !positive(limits.force_N) || !positive(limits.deviation_m) || !positive(limits.deviation_rad) ||
        !positive(limits.longestStep_s) || (limits.saturation_N && !positive(*limits.saturation_N)) ||
        !positive(task.normalCompliance_mPerN) || !positive(task.feedForward.period_s) ||
        !notNegative(task.pointFor_s) || !notNegative(exit.hold_s) || !notNegative(exit.alphaWithin_rad) ||
        !notNegative(exit.dzmpYWithin_m) || !notNegative(exit.copYWithin_m) || !notNegative(exit.path_m) ||
        !notNegative(exit.time_s) || task.gains.integralLimit.minCoeff() < 0.0)
        return tl::unexpected(TaskRefusal::badLimit);
    if (desired.force_N < 0.0 || desired.force_N > limits.force_N)
        return tl::unexpected(TaskRefusal::forceTooHigh);
    for (const double place_m : {desired.copX_m, desired.copY_m, desired.wx_m, desired.wy_m})
        if (std::abs(place_m) > kFarthestFeature_m)
            return tl::unexpected(TaskRefusal::featureOutside);
    if (std::abs(desired.alphaZ_rad) > 90.0 * kRadPerDegree)
        return tl::unexpected(TaskRefusal::featureOutside);
    const Vector6 highest = highestGain();
    if ((task.gains.proportional.cwiseAbs().array() > highest.array()).any() ||
        (task.gains.integral.cwiseAbs().array() > highest.array()).any())
        return tl::unexpected(TaskRefusal::gainTooHigh);
    return {};
}

tl::expected<void, TaskRefusal> check(const ServoPlan& plan) {
    const auto missing = [&](const std::optional<std::size_t>& index) {
        return index && *index >= plan.tasks.size();
    };
    if (plan.start >= plan.tasks.size())
        return tl::unexpected(TaskRefusal::badReference);
    for (const ServoTask& task : plan.tasks) {
        if (missing(task.next) || missing(task.ifPoint) || missing(task.afterSearch))
            return tl::unexpected(TaskRefusal::badReference);
        if (const auto fine = check(task); !fine)
            return fine;
    }
    const SearchSettings& search = plan.search;
    if (!notNegative(search.lostAfter_s) || !notNegative(search.retreat_m) || !notNegative(search.depth_m) ||
        !notNegative(search.probeStep_m) || !positive(search.speed_mPerS) || search.probes < 1 ||
        search.probes > 20)
        return tl::unexpected(TaskRefusal::badLimit);
    return {};
}

ServoTask freeMotion(double speed_mPerS) {
    ServoTask task;
    task.kind = TaskKind::freeMotion;
    task.needsContact = false;
    task.feedForward.constant_Sensor[kZ] = speed_mPerS;
    task.exit.contact = true;
    return task;
}

ServoTask alignTask(double force_N) {
    ServoTask task = contactTask(TaskKind::align, force_N);
    task.jacobian = JacobianRule::point;
    task.projection.wy = true;
    // A contact at +x turns the sensor about +y: that side lifts, and the other one comes down.
    task.gains.proportional[kWy] = -2.5;
    task.exit.edge = true;
    task.exit.hold_s = 0.1;
    return task;
}

ServoTask edgeControlTask(double force_N) {
    ServoTask task = contactTask(TaskKind::edgeControl, force_N);
    task.jacobian = JacobianRule::edge;
    task.projection.wy = true;
    task.projection.wz = true;
    // Row 5 is -DZMP_y, so its error is +DZMP_y: more load at +x turns the sensor about +y.
    task.gains.proportional[kWy] = 5.0;
    task.gains.integral[kWy] = 2.5;
    task.gains.proportional[kWz] = -2.0;
    task.gains.integral[kWz] = -0.3;
    return task;
}

ServoTask exploreTask(double force_N, double speed_mPerS) {
    ServoTask task = edgeControlTask(force_N);
    task.kind = TaskKind::explore;
    task.projection.x = true;
    task.desired.copX_m = kSlideCopX_m;
    task.gains.proportional[kX] = speed_mPerS / kSlideCopX_m;
    return task;
}

ServoTask pointFollowingTask(double force_N) {
    ServoTask task = contactTask(TaskKind::pointFollowing, force_N);
    task.jacobian = JacobianRule::point;
    task.projection.x = true;
    // Sideways only the springs of the arm hold its mass. It lags by 0.17 s (2 zeta / omega), and a faster
    // loop would overshoot a step.
    task.gains.proportional[kX] = task.gains.proportional[kY] = -2.0;
    task.gains.integral[kX] = task.gains.integral[kY];
    return task;
}

ServoTask rollTask(double force_N, double angle_rad, double period_s) {
    ServoTask task = pointFollowingTask(force_N);
    task.kind = TaskKind::roll;
    // The integral of a cosine of this amplitude swings by +-angle.
    task.feedForward.sway_Sensor[kWy] = angle_rad * 2.0 * std::numbers::pi / period_s;
    task.feedForward.period_s = period_s;
    return task;
}

ServoTask comanipulationTask(double force_N) {
    ServoTask task = contactTask(TaskKind::comanipulation, force_N);
    task.jacobian = JacobianRule::edge;
    task.projection.com = true;
    task.projection.wz = true;
    // More load at +x moves the sensor there, below the centre of mass.
    task.gains.proportional[kX] = 2.0;
    task.gains.proportional[kWz] = -2.0;
    task.gains.integral[kWz] = -0.3;
    return task;
}

ServoPlan explorePlan(double force_N, double speed_mPerS, bool dzmp) {
    ServoPlan plan = sequence(dzmp ? "explore" : "explore_baseline",
                              {freeMotion(), alignTask(force_N), edgeControlTask(force_N),
                               exploreTask(force_N, speed_mPerS), edgeControlTask(force_N)});
    ExitCondition& aligned = plan.tasks[2].exit;
    aligned.edge = true;
    aligned.alphaWithin_rad = 1.0 * kRadPerDegree;
    aligned.dzmpYWithin_m = 0.0005;
    aligned.copYWithin_m = 0.0005;
    aligned.hold_s = 0.2;
    for (std::size_t i = 1; i < plan.tasks.size(); ++i) {
        if (i > 1 && dzmp)
            plan.tasks[i].ifPoint = 1;
        plan.tasks[i].afterSearch = 1;
    }
    if (!dzmp)
        for (std::size_t i = 3; i < plan.tasks.size(); ++i) {
            plan.tasks[i].projection.wy = false;
            plan.tasks[i].limits.saturation_N.reset();
        }
    return plan;
}

ServoPlan comanipulationPlan(double force_N) {
    ServoPlan plan =
        sequence("comanipulation", {freeMotion(), alignTask(force_N), comanipulationTask(force_N)});
    plan.tasks[2].afterSearch = 1;
    return plan;
}

ServoPlan rollPlan(double force_N, double angle_rad, double period_s) {
    ServoPlan plan =
        sequence("roll", {freeMotion(), pointFollowingTask(force_N), rollTask(force_N, angle_rad, period_s)});
    plan.tasks[1].exit.time_s = 3.0;
    return plan;
}

ServoPlan pointPlan(double force_N) {
    return sequence("point", {freeMotion(), pointFollowingTask(force_N)});
}

} // namespace teleta::servo
