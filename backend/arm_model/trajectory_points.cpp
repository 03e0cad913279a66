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
    double braking_s = 0.0;
    for (std::size_t i = 0; i < commanded.size(); ++i) {
        const double v = rate[i];
        moving.position[i] = commanded[i] + v * kFirstPoint_s;
        resting.position[i] = moving.position[i] + v * std::abs(v) / (2.0 * deceleration[i]);
        braking_s = std::max(braking_s, std::abs(v) / deceleration[i]);
    }
    resting.time_s = kFirstPoint_s + (braking_s > 0.0 ? braking_s : kFirstPoint_s);
    return {moving, resting};
}

} // namespace teleta::arm_model
