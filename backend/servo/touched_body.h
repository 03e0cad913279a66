// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace teleta::servo {

/// The round body that an array touches, for drawing: a tube of one radius with round ends around a line, or
/// a ball around its only point. Frame {o}, which moves with the body.
struct TouchedBody {
    std::string name;
    std::vector<Eigen::Vector3d> axis_m{}; ///< empty: the body is not known, or not round
    double radius_m = 0.0;                 ///< > 0 where there is an axis
};

} // namespace teleta::servo
