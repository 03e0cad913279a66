// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/active_limits.h"
#include "backend/servo/servo_task.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>

namespace teleta::servo {

/// One servo cycle as it is kept and drawn. What is not defined or not known is NaN.
struct ServoStep {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::uint64_t run = 0; ///< restarts of the source before this step
    double time_s = 0.0;   ///< of the source
    TaskKind task = TaskKind::freeMotion;
    bool touching = false;
    bool moment = true;     ///< DZMP turns the sensor; false: the baseline
    double force_N = kNone; ///< all that presses the array and its housing, as a force sensor behind it reads
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
    double massX_m = kNone; ///< of a weight on a tray, along the bar; what is true
    ActiveLimits limits;    ///< that acted on the command
    Eigen::Vector3d p_Base_Sensor = Eigen::Vector3d::Zero();
    Eigen::Quaterniond q_Base_Sensor{kNone, kNone, kNone, kNone};    ///< how it is turned
    Eigen::Quaterniond q_Base_Reference{kNone, kNone, kNone, kNone}; ///< how it is commanded to be turned
    /// Centre of contact of a step that explores an edge; NaN otherwise.
    Eigen::Vector3d p_Base_Contact = Eigen::Vector3d::Constant(kNone);
};

} // namespace teleta::servo
