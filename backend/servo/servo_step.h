// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/active_limits.h"
#include "backend/servo/servo_task.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>

namespace teleta::servo {

/// One servo cycle as it is stored and drawn. Undefined and unknown values are NaN.
struct ServoStep {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::uint64_t run = 0; ///< number of restarts of the source before this step
    double time_s = 0.0;   ///< of the source
    TaskKind task = TaskKind::freeMotion;
    bool touching = false;
    bool moment = true; ///< DZMP turns the sensor; false: the baseline without it
    double force_N =
        kNone; ///< total force on the array and its housing, as a force sensor behind it would read
    double desired_N = kNone;
    double copY_m = kNone;
    double copYDesired_m = kNone;
    double cocX_m = kNone;
    double cocXDesired_m = kNone; ///< ServoOutput::desiredCocX_m
    double dzmpY_m = kNone;
    double dzmpYDesired_m = kNone;
    double dzmpYTrue_m = kNone; ///< from the true loads of the taxels
    double alphaZ_rad = kNone;
    double alphaZDesired_rad = kNone;
    double massX_m = kNone; ///< true position of a weight on a tray, along the bar
    ActiveLimits limits;    ///< limits that acted on the command
    Eigen::Vector3d p_Base_Sensor = Eigen::Vector3d::Zero();
    Eigen::Quaterniond q_Base_Sensor{kNone, kNone, kNone, kNone};    ///< measured orientation
    Eigen::Quaterniond q_Base_Reference{kNone, kNone, kNone, kNone}; ///< commanded orientation
    /// Centre of contact while an edge is explored; otherwise NaN.
    Eigen::Vector3d p_Base_Contact = Eigen::Vector3d::Constant(kNone);
};

} // namespace teleta::servo
