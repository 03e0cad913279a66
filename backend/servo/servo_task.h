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
    touch, ///< as the contact is at the moment
};

/// What a task wants to feel, in the space of J^-1 s.
struct DesiredFeatures {
    double copX_m = 0.0;
    double copY_m = 0.0;
    double force_N = 0.0;
    double wx_m = 0.0; ///< row 4: -DZMP_x of an edge, CoC_y of a point
    double wy_m = 0.0; ///< row 5: -DZMP_y of an edge, CoC_x of a point
    double alphaZ_rad = 0.0;
};

/// From the task's error to a twist: u = K_P e + K_I int e dt. The signs say into which direction the sensor
/// moves: towards the contact for x and y (negative, since a sensor that moves to +x sees the contact go to
/// -x), into the object for a force that is too low (positive), away from the side that bears more for DZMP.
struct ServoGains {
    Vector6 proportional = Vector6::Zero();  ///< 1/s; rad/(s m) for wx and wy
    Vector6 integral = Vector6::Zero();      ///< 1/s^2; rad/(s^2 m) for wx and wy
    Vector6 integralLimit = Vector6::Zero(); ///< highest share of the integral in the twist; m/s, rad/s; >= 0
};

struct ServoLimits {
    double toolSpeed_mPerS = 0.05; ///< |v| of the sensor's centre; > 0
    double turnRate_radPerS = 0.5; ///< |w|; > 0
    double force_N = 30.0;         ///< above this measured force the sensor only retreats; > 0
    double deviation_m = 0.060;    ///< the command stays this near to the measured pose; > 0
    double deviation_rad = 0.5;    ///< the same for the turn; > 0
    /// With a taxel at this load the force reads too low, and the sensor pushes no further. Empty: it does.
    std::optional<double> saturation_N = 2.89;
    double longestStep_s = 0.05; ///< a longer gap between frames counts as this; > 0
};

/// A motion that is added whatever is felt: a constant, and one that goes back and forth.
///   constant + sway cos(2 pi t/period),  t from the start of the task
struct FeedForward {
    Twist constant_Sensor = Twist::Zero();
    Twist sway_Sensor = Twist::Zero();
    double period_s = 1.0; ///< > 0
};

/// When a task is done: all that is named holds for hold_s. Nothing named: never.
struct ExitCondition {
    bool contact = false;                  ///< a taxel is active
    bool edge = false;                     ///< the contact is an edge
    std::optional<double> alphaWithin_rad; ///< |desired - alpha_z|
    std::optional<double> dzmpYWithin_m;
    std::optional<double> copYWithin_m; ///< |desired - CoP_y|
    std::optional<double> path_m;       ///< way of the commanded sensor since the start of the task
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
    /// Compliance from a commanded displacement along z to the force: arm and skin in series. With it d_z is
    /// the way that the command has to go, and the gain of z is a bandwidth. As it is here: an arm of
    /// 1000 N/m and 14 taxels of 1200 N/m.
    double normalCompliance_mPerN = 1.0 / 1000.0 + 1.0 / 16800.0;
    bool needsContact = true;      ///< without contact the sensor searches for it
    bool turnsAboutContact = true; ///< turns leave the contact where it is; false: about the sensor's centre
    ExitCondition exit;
    std::optional<std::size_t> next;        ///< task after the exit; none: this one goes on
    std::optional<std::size_t> ifPoint;     ///< task when the contact has been a point for pointFor_s
    std::optional<std::size_t> afterSearch; ///< task when the contact is found again; none: this one
    double pointFor_s = 0.5;
};

/// What the controller does when the contact is gone: back off along the last normal, then feel forward,
/// first where the contact was, then step by step back along the way; at the end it holds still.
struct SearchSettings {
    double lostAfter_s = 0.05;  ///< without an active taxel
    double retreat_m = 0.003;   ///< from the last measured pose with contact
    double depth_m = 0.010;     ///< how far each probe goes beyond that pose; bound of the search
    int probes = 3;             ///< 1 .. 20
    double probeStep_m = 0.004; ///< between two probes
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
    badLimit,       ///< a limit, the compliance or the period is not > 0, or a bound is negative
    forceTooHigh,   ///< the desired force is negative or over the task's force limit
    featureOutside, ///< a desired place is not on the sensor (beyond 50 mm), or an angle beyond +-90 degrees
    gainTooHigh,    ///< a gain's magnitude is over kHighestGain
    badReference,   ///< start, next, ifPoint or afterSearch name no task of the plan, or there is no task
};

/// Highest magnitude of a gain: K_P of x, y, z, wz in 1/s; of wx, wy in rad/(s m). K_I the same per s.
[[nodiscard]] Vector6 highestGain();

[[nodiscard]] tl::expected<void, TaskRefusal> check(const ServoTask& task);
[[nodiscard]] tl::expected<void, TaskRefusal> check(const ServoPlan& plan);

/// The tasks of the paper with gains for an arm of 1000 N/m. force_N: desired.
[[nodiscard]] ServoTask freeMotion(double speed_mPerS = 0.01); ///< phase I
[[nodiscard]] ServoTask alignTask(double force_N);             ///< phase II, eq. (16)
[[nodiscard]] ServoTask edgeControlTask(double force_N);       ///< phase III, eq. (17)
[[nodiscard]] ServoTask exploreTask(double force_N,
                                    double speed_mPerS); ///< phase IV, eq. (18) with gamma_x = 1
/// The sensor turns back and forth about the contact around its y axis, by +-angle_rad.
[[nodiscard]] ServoTask rollTask(double force_N, double angle_rad, double period_s);
[[nodiscard]] ServoTask pointFollowingTask(double force_N);
[[nodiscard]] ServoTask comanipulationTask(double force_N); ///< eq. (19)-(20), gamma_com in column 5

/// Phases I to IV; without DZMP it is the baseline of section 5.2.1: no turn about y, no way back to phase II
/// and no guard against saturation.
[[nodiscard]] ServoPlan explorePlan(double force_N = 5.0, double speed_mPerS = 0.005, bool dzmp = true);
[[nodiscard]] ServoPlan comanipulationPlan(double force_N = 6.0);
[[nodiscard]] ServoPlan rollPlan(double force_N = 5.0, double angle_rad = 0.25, double period_s = 10.0);
[[nodiscard]] ServoPlan pointPlan(double force_N = 3.0);

} // namespace teleta::servo
