// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/predicted_times.h"

#include <cmath>
#include <vector>

namespace teleta::pattern {

namespace {

constexpr double kLongestStepBetween_s = 0.001;

} // namespace

void forEachPredictedTime(const Pattern& pattern, const MotorProfiles& profiles,
                          std::span<const double> times_s,
                          const std::function<bool(std::size_t index, const core::Intensities&)>& visit) {
    const CompiledPattern compiled(pattern);
    std::vector<MotorModel> motors;
    for (const MotorProfile& profile : profiles)
        motors.emplace_back(profile);
    double now_s = 0.0;
    for (std::size_t k = 0; k < times_s.size(); ++k) {
        const double steps = std::ceil((times_s[k] - now_s) / kLongestStepBetween_s);
        for (double step = 0.0; step < steps; ++step) {
            const double step_s = (times_s[k] - now_s) / steps;
            const core::Intensities wanted = compiled.evaluate(now_s + (step + 0.5) * step_s);
            for (std::size_t i = 0; i < core::kTactors; ++i)
                motors[i].step(driveOf(profiles[i], wanted[i]), step_s);
        }
        now_s = times_s[k];
        core::Intensities intensities{};
        for (std::size_t i = 0; i < core::kTactors; ++i)
            intensities[i] = intensityOfSpeed(profiles[i], motors[i].speed_Hz());
        if (!visit(k, intensities))
            return;
    }
}

} // namespace teleta::pattern
