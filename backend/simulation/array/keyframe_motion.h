// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"

#include <array>
#include <vector>

namespace teleta::simulation {

/// Position of an indenter in the frame {s} of the array.
struct Pose {
    double x_m = 0.0;
    double y_m = 0.0;
    double depth_m = 0.0; ///< of its lowest point under the free surface; negative: above it
    double angle_rad = 0.0;
};

/// The motion through a scene's keyframes: a cubic Hermite curve a coordinate, with slopes that keep it
/// monotone between keyframes, so it never leaves the range of the two keyframes around it. At the first and
/// the last keyframe it rests; in a loop it goes through them. Before and after it stays where it is.
/// Thread: any (const).
/// Source: F. N. Fritsch, J. Butland, A method for constructing local monotone piecewise cubic interpolants
/// (1984).
class KeyframeMotion {
public:
    /// keyframes: at least one, times strictly increasing.
    KeyframeMotion(std::vector<scene::Keyframe> keyframes, bool loop);

    [[nodiscard]] Pose at(double time_s) const;

private:
    using Coordinates = std::array<double, 4>;

    std::vector<double> m_time_s;
    std::vector<Coordinates> m_value;
    std::vector<Coordinates> m_slope;
    bool m_loop;
};

} // namespace teleta::simulation
