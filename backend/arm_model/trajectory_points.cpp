// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/trajectory_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace teleta::arm_model {

std::array<TrajectoryPoint, 2> trajectoryPoints(const core::JointVector& commanded,
                                                const core::JointVector& rate,
                                                const core::JointVector& deceleration) {
    TrajectoryPoint moving{kFirstPoint_s, commanded, rate};
    TrajectoryPoint resting{0.0, commanded, core::JointVector::zeros(commanded.size())};
    const double braking_s = brakingTime_s(rate, deceleration);
    for (std::size_t i = 0; i < commanded.size(); ++i) {
        const double v = rate[i];
        moving.position[i] = commanded[i] + v * kFirstPoint_s;
        resting.position[i] = moving.position[i] + v * std::abs(v) / (2.0 * deceleration[i]);
    }
    resting.time_s = kFirstPoint_s + (braking_s > 0.0 ? braking_s : kFirstPoint_s);
    return {moving, resting};
}

std::array<TrajectoryPoint, 2> brakingPoints(const core::JointVector& commanded,
                                             const core::JointVector& rate,
                                             const core::JointVector& deceleration) {
    const double whole_s = std::max(brakingTime_s(rate, deceleration), kFirstPoint_s);
    const auto at = [&](double time_s) {
        TrajectoryPoint point{time_s, commanded, core::JointVector::zeros(commanded.size())};
        for (std::size_t i = 0; i < commanded.size(); ++i) {
            const double v = rate[i];
            const double a = std::copysign(deceleration[i], v);
            const double braked_s = std::min(time_s, v / a);
            point.position[i] = commanded[i] + v * braked_s - 0.5 * a * braked_s * braked_s;
            point.velocity[i] = time_s < v / a ? v - a * time_s : 0.0;
        }
        return point;
    };
    return {at(0.5 * whole_s), at(whole_s)};
}

double brakingTime_s(const core::JointVector& rate, const core::JointVector& deceleration) {
    double time_s = 0.0;
    for (std::size_t i = 0; i < rate.size(); ++i)
        time_s = std::max(time_s, std::abs(rate[i]) / deceleration[i]);
    return time_s;
}

} // namespace teleta::arm_model
