// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/tactile_jacobian.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::servo {

enum class TaskKind { freeMotion, align, edgeControl, explore, roll, pointFollowing, comanipulation };

/// "free_motion", "align", "edge_control", "explore", "roll", "point_following", "comanipulation".
[[nodiscard]] const char* toString(TaskKind kind);

/// Which inverse Jacobian a task uses.
enum class JacobianRule {
    point, ///< beta = 0
    edge,  ///< beta = 1
    touch, ///< by the current type of the contact
};

/// Desired features of a task, in the space of J^-1 s.
struct DesiredFeatures {
    double copX_m = 0.0;
    double copY_m = 0.0;
    double force_N = 0.0;
    double wx_m = 0.0; ///< row 4: -DZMP_x of an edge, CoC_y of a point
    double wy_m = 0.0; ///< row 5: -DZMP_y of an edge, CoC_x of a point
    double alphaZ_rad = 0.0;
};

/// Gains from the error of a task to a twist: u = K_P e + K_I int e dt. Their signs define in which direction
/// the sensor moves: towards the contact for x and y (negative, because when the sensor moves to +x the
/// contact moves to -x on it), into the object when the force is too low (positive), away from the more
/// heavily loaded side for DZMP.
struct ServoGains {
    Vector6 proportional = Vector6::Zero();  ///< 1/s; rad/(s m) for wx and wy
    Vector6 integral = Vector6::Zero();      ///< 1/s^2; rad/(s^2 m) for wx and wy
    Vector6 integralLimit = Vector6::Zero(); ///< largest share of the integral in the twist; m/s, rad/s; >= 0
};

struct ServoLimits {
    double toolSpeed_mPerS = 0.05; ///< |v| of the sensor's centre; > 0
    double turnRate_radPerS = 0.5; ///< |w|; > 0
    double force_N = 30.0;         ///< above this measured force the sensor may only retreat; > 0
    double deviation_m = 0.060;    ///< largest distance of the command from the measured pose; > 0
    double deviation_rad = 0.5;    ///< the same for the orientation; > 0
    /// When a taxel reads this load it is saturated and the measured force too low, so the sensor must not
    /// push further. Empty: no such limit.
    std::optional<double> saturation_N = 2.89;
    double longestStep_s = 0.05; ///< a longer time between two frames counts as this; > 0
};

/// Motion that is added regardless of the features, a constant and an oscillating part:
///   constant + sway cos(2 pi t/period),  t from the start of the task
struct FeedForward {
    Twist constant_Sensor = Twist::Zero();
    Twist sway_Sensor = Twist::Zero();
    double period_s = 1.0; ///< > 0
};

/// When a task is done: when all conditions that are set have held for hold_s. If none is set, never.
struct ExitCondition {
    bool contact = false;                  ///< a taxel is active
    bool edge = false;                     ///< the contact is an edge
    std::optional<double> alphaWithin_rad; ///< |desired - alpha_z|
    std::optional<double> dzmpYWithin_m;
    std::optional<double> copYWithin_m; ///< |desired - CoP_y|
    std::optional<double> path_m;       ///< length of the commanded path since the start of the task
    std::optional<double> time_s;       ///< since the start of the task
    double hold_s = 0.0;                ///< >= 0

    [[nodiscard]] bool named() const {
        return contact || edge || alphaWithin_rad || dzmpYWithin_m || copYWithin_m || path_m || time_s;
    }
};

/// One task of the servo controller, as data.
struct ServoTask {
    TaskKind kind = TaskKind::freeMotion;
    JacobianRule jacobian = JacobianRule::touch;
    Projection projection;
    DesiredFeatures desired;
    ServoGains gains;
    FeedForward feedForward;
    ServoLimits limits;
    /// Compliance C_z from a commanded displacement along z to the force: arm and skin in series. With it d_z
    /// is the distance that the command has to move, and the gain of z is a bandwidth. Default: an arm of
    /// 1000 N/m and 14 taxels of 1200 N/m each.
    double normalCompliance_mPerN = 1.0 / 1000.0 + 1.0 / 16800.0;
    bool needsContact = true; ///< if there is no contact, the sensor searches for it
    bool turnsAboutContact =
        true; ///< turns keep the contact in place; false: turns are about the centre of the sensor
    ExitCondition exit;
    std::optional<std::size_t> next; ///< task after the exit; none: this task continues
    std::optional<std::size_t>
        ifPoint; ///< task that follows when the contact has been a point for pointFor_s
    std::optional<std::size_t>
        afterSearch; ///< task that follows when a search has found the contact; none: this one
    double pointFor_s = 0.5;
};

/// Search for a lost contact: retreat along the last normal, then probe forwards, first where the contact
/// was, then step by step back along the path; at the end stand still.
struct SearchSettings {
    double lostAfter_s = 0.05;  ///< time without an active taxel
    double retreat_m = 0.003;   ///< from the last measured pose with contact
    double depth_m = 0.010;     ///< how far each probe goes beyond that pose; bounds the search
    int probes = 3;             ///< 1 .. 20
    double probeStep_m = 0.004; ///< distance between two probes
    double speed_mPerS = 0.010; ///< > 0
};

/// Tasks that follow each other.
struct ServoPlan {
    std::string name;
    std::vector<ServoTask> tasks;
    std::size_t start = 0;
    SearchSettings search;
};

enum class TaskRefusal {
    notFinite,      ///< a number is NaN or infinite
    badLimit,       ///< a limit, the compliance or the period is <= 0, or a bound is negative
    forceTooHigh,   ///< the desired force is negative or above the force limit of the task
    featureOutside, ///< a desired place is off the sensor (beyond 50 mm), or an angle beyond +-90 degrees
    gainTooHigh,    ///< the magnitude of a gain exceeds highestGain()
    badReference, ///< start, next, ifPoint or afterSearch is not the index of a task, or the plan has no task
};

/// Largest magnitude of a gain: K_P of x, y, z, wz in 1/s, of wx, wy in rad/(s m); K_I the same per s.
[[nodiscard]] Vector6 highestGain();

[[nodiscard]] tl::expected<void, TaskRefusal> check(const ServoTask& task);
[[nodiscard]] tl::expected<void, TaskRefusal> check(const ServoPlan& plan);

/// The tasks of the paper with gains for an arm of 1000 N/m. force_N: desired.
[[nodiscard]] ServoTask freeMotion(double speed_mPerS = 0.01); ///< phase I
[[nodiscard]] ServoTask alignTask(double force_N);             ///< phase II, eq. (16)
[[nodiscard]] ServoTask edgeControlTask(double force_N);       ///< phase III, eq. (17)
[[nodiscard]] ServoTask exploreTask(double force_N,
                                    double speed_mPerS); ///< phase IV, eq. (18) with gamma_x = 1
/// Turns the sensor back and forth about the contact around its y axis, by +-angle_rad.
[[nodiscard]] ServoTask rollTask(double force_N, double angle_rad, double period_s);
[[nodiscard]] ServoTask pointFollowingTask(double force_N);
[[nodiscard]] ServoTask comanipulationTask(double force_N); ///< eq. (19)-(20), gamma_com in column 5

/// Phases I to IV. dzmp = false is the baseline of section 5.2.1: no turn about y, no return to phase II and
/// no limit on saturation.
[[nodiscard]] ServoPlan explorePlan(double force_N = 5.0, double speed_mPerS = 0.005, bool dzmp = true);
[[nodiscard]] ServoPlan comanipulationPlan(double force_N = 6.0);
[[nodiscard]] ServoPlan rollPlan(double force_N = 5.0, double angle_rad = 0.25, double period_s = 10.0);
[[nodiscard]] ServoPlan pointPlan(double force_N = 3.0);

} // namespace teleta::servo
