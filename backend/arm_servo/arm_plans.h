// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

#include <array>

namespace teleta::arm_servo {

/// The servo tasks of the scenes, which an arm with a pad can do as well.
enum class ArmTask { point, explore, roll, comanipulation };
inline constexpr std::array kArmTasks{ArmTask::point, ArmTask::explore, ArmTask::roll,
                                      ArmTask::comanipulation};

inline constexpr double kLeastForce_N = 0.5;
inline constexpr double kHighestForce_N = 15.0;
/// Of a taxel, as in the scenes. Nobody tells that of a real pad.
inline constexpr double kTaxelStiffness_NPerM = 1200.0;

/// The force to begin with: that of an edge is spread over many taxels, each of which has to be active.
[[nodiscard]] double usualForce_N(ArmTask task);

/// The plan of a task as scenes have it, for an arm that follows speeds and not springs. The arm comes near
/// slowly, since it goes on for a while before a contact takes effect. Where taxels are saturated is not
/// known. force_N: clamped to kLeastForce_N .. kHighestForce_N; not finite: the least. Passes servo::check().
/// Thread: any (pure).
[[nodiscard]] servo::ServoPlan armPlan(ArmTask task, double force_N);

/// Compliance C_z for a contact of so many taxels, half of that of their springs: with it the gain of the
/// force is half its bandwidth, and the loop has room for the delay of an arm and for a pad that is harder.
/// At least one taxel counts. Thread: any (pure).
[[nodiscard]] double contactCompliance_mPerN(int taxels);

} // namespace teleta::arm_servo
