// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d_motion.h"

#include <algorithm>
#include <cmath>

namespace teleta::mouse3d {

double scaleAxis(std::int16_t counts, const MotionLimits& limits) {
    const double share = std::clamp(counts / limits.fullScale_counts, -1.0, 1.0);
    const double beyond = std::abs(share) - limits.deadZone;
    return beyond > 0.0 ? std::copysign(beyond / (1.0 - limits.deadZone), share) : 0.0;
}

SixAxes scaleAxes(const RawAxes& raw, const MotionLimits& limits) {
    const auto turned = [&limits](const std::array<std::int16_t, 3>& axes) {
        const auto negative = [&limits](std::int16_t counts) {
            const double value = scaleAxis(counts, limits);
            return value == 0.0 ? 0.0 : -value;
        };
        return std::array<double, 3>{scaleAxis(axes[0], limits), negative(axes[1]), negative(axes[2])};
    };
    return {turned(raw.translation), turned(raw.rotation)};
}

} // namespace teleta::mouse3d
