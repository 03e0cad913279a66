// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/arm_plans.h"

#include <algorithm>
#include <cmath>

namespace teleta::arm_servo {

namespace {

constexpr double kApproach_mPerS = 0.001;
constexpr double kSearch_mPerS = 0.002;
constexpr double kSlide_mPerS = 0.005;
constexpr double kRoll_rad = 0.15;
constexpr double kRollPeriod_s = 20.0;
constexpr double kToolSpeed_mPerS = 0.02;
constexpr double kTurnRate_radPerS = 0.2;
/// As with the scenes: where the arm arrives it may bounce once, and that is no loss of contact.
constexpr double kBounce_s = 0.2;
/// A pad that reads too little must not make the arm push faster and faster.
constexpr double kPush_mPerS = 0.002;
constexpr double kDeviation_m = 0.01;
constexpr double kDeviation_rad = 0.1;
/// Above this multiple of the wanted force, and at least above so much, the pad may only retreat.
constexpr double kForceShare = 2.0;
constexpr double kForceOffset_N = 5.0;

servo::ServoPlan planOf(ArmTask task, double force_N) {
    switch (task) {
    case ArmTask::point:
        return servo::pointPlan(force_N);
    case ArmTask::explore:
        return servo::explorePlan(force_N, kSlide_mPerS);
    case ArmTask::roll:
        return servo::rollPlan(force_N, kRoll_rad, kRollPeriod_s);
    case ArmTask::comanipulation:
        break;
    }
    return servo::comanipulationPlan(force_N);
}

} // namespace

double usualForce_N(ArmTask task) {
    constexpr double kOfPoint_N = 3.0;
    constexpr double kOfEdge_N = 8.0;
    return task == ArmTask::point || task == ArmTask::roll ? kOfPoint_N : kOfEdge_N;
}

double contactCompliance_mPerN(int taxels) {
    return 0.5 / (std::max(taxels, 1) * kTaxelStiffness_NPerM);
}

servo::ServoPlan armPlan(ArmTask task, double force_N) {
    const double wanted_N =
        std::isfinite(force_N) ? std::clamp(force_N, kLeastForce_N, kHighestForce_N) : kLeastForce_N;
    servo::ServoPlan plan = planOf(task, wanted_N);
    plan.tasks.front().feedForward.constant_Sensor[servo::kZ] = kApproach_mPerS;
    plan.search.lostAfter_s = kBounce_s;
    plan.search.speed_mPerS = kSearch_mPerS;
    for (servo::ServoTask& each : plan.tasks) {
        each.normalCompliance_mPerN = contactCompliance_mPerN(1);
        each.limits.saturation_N.reset();
        each.gains.integralLimit[servo::kZ] = kPush_mPerS;
        each.limits.toolSpeed_mPerS = kToolSpeed_mPerS;
        each.limits.turnRate_radPerS = kTurnRate_radPerS;
        each.limits.deviation_m = kDeviation_m;
        each.limits.deviation_rad = kDeviation_rad;
        each.limits.force_N = kForceShare * wanted_N + kForceOffset_N;
    }
    return plan;
}

} // namespace teleta::arm_servo
