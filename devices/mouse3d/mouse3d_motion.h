// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/mouse3d/mouse3d_reports.h"

#include <array>
#include <cstdint>

namespace teleta::mouse3d {

/// What the hand wants, -1..1 an axis, in the operator's frame {m}: x right, y away from the operator, z up;
/// rotations about them, right-handed.
struct SixAxes {
    std::array<double, 3> translation{};
    std::array<double, 3> rotation{};

    bool operator==(const SixAxes&) const = default;
};

/// How counts become motion.
struct MotionLimits {
    double fullScale_counts = 350.0; ///< > 0; deflection at which an axis is 1
    double deadZone = 0.06;          ///< 0 .. 0.9; share of the full scale that counts as rest
};

/// One axis:
///   u = limit(counts / full scale, -1, 1)
///   result = sign(u) max(0, |u| - d) / (1 - d)
/// so that motion begins at 0 beyond the dead zone d. Thread: any (pure).
[[nodiscard]] double scaleAxis(std::int16_t counts, const MotionLimits& limits);

/// All axes, turned from the mouse's frame into {m}. Thread: any (pure).
[[nodiscard]] SixAxes scaleAxes(const RawAxes& raw, const MotionLimits& limits);

} // namespace teleta::mouse3d
