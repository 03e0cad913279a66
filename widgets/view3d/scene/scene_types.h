// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace teleta::view3d {

/// One link of the arm, drawn as a tube with a ball at its joint. It runs from the origin of its frame along
/// its frame's x axis.
struct ArmLink {
    Eigen::Isometry3d X_World_Link = Eigen::Isometry3d::Identity();
    double length_m = 0.0; ///< >= 0
    double radius_m = 0.0; ///< > 0
};

} // namespace teleta::view3d
