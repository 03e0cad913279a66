// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_tuning.h"

#include <algorithm>
#include <cmath>

namespace teleta::servo {

namespace {

double within(double value, double lowest, double highest, double otherwise) {
    return std::isfinite(value) ? std::clamp(value, lowest, highest) : otherwise;
}

} // namespace

bool turnsByMoment(TaskKind kind) {
    return kind == TaskKind::edgeControl || kind == TaskKind::explore;
}

TuningBounds boundsOf(const ServoPlan& plan) {
    const ServoTuning own = tuningOf(plan);
    TuningBounds bounds;
    bounds.leastForce_N = std::min(bounds.leastForce_N, own.force_N);
    bounds.highestForce_N = std::max(bounds.highestForce_N, own.force_N);
    bounds.highestSlide_mPerS = std::max(bounds.highestSlide_mPerS, own.slide_mPerS);
    return bounds;
}

ServoTuning clamped(const ServoTuning& tuning, const TuningBounds& bounds) {
    const ServoTuning usual;
    ServoTuning result = tuning;
    result.force_N = within(tuning.force_N, bounds.leastForce_N, bounds.highestForce_N, usual.force_N);
    result.slide_mPerS = within(tuning.slide_mPerS, 0.0, bounds.highestSlide_mPerS, usual.slide_mPerS);
    result.gain = within(tuning.gain, ServoTuning::kLeastGain, ServoTuning::kHighestGain, usual.gain);
    return result;
}

ServoTuning tuningOf(const ServoPlan& plan) {
    ServoTuning tuning;
    for (const ServoTask& task : plan.tasks) {
        if (task.needsContact)
            tuning.force_N = task.desired.force_N;
        if (task.kind != TaskKind::explore)
            continue;
        tuning.slide_mPerS = task.gains.proportional[kX] * task.desired.copX_m;
        tuning.moment = task.projection.wy;
    }
    return tuning;
}

ServoPlan tuned(const ServoPlan& plan, const ServoTuning& tuning) {
    const ServoTuning wanted = clamped(tuning, boundsOf(plan));
    ServoPlan result = plan;
    const Vector6 highest = highestGain();
    const bool explores = std::any_of(plan.tasks.begin(), plan.tasks.end(),
                                      [](const ServoTask& task) { return task.kind == TaskKind::explore; });
    for (ServoTask& task : result.tasks) {
        if (!task.needsContact)
            continue;
        task.desired.force_N = std::min(wanted.force_N, task.limits.force_N);
        const double slide = task.gains.proportional[kX];
        task.gains.proportional =
            (wanted.gain * task.gains.proportional).cwiseMin(highest).cwiseMax(-highest);
        task.gains.integral = (wanted.gain * task.gains.integral).cwiseMin(highest).cwiseMax(-highest);
        if (task.kind == TaskKind::explore)
            task.gains.proportional[kX] =
                task.desired.copX_m != 0.0 ? wanted.slide_mPerS / task.desired.copX_m : slide;
        // A plan that never slides has no baseline to compare with.
        if (explores && turnsByMoment(task.kind))
            task.projection.wy = wanted.moment;
    }
    return result;
}

} // namespace teleta::servo
