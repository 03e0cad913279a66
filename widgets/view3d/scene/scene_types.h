// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace teleta::view3d {

/// An object that was found before the one that is touched now. World frame, m.
struct DrawnObject {
    std::uint64_t number = 0; ///< decides the colour
    QString label;            ///< empty: none is written
    std::vector<Eigen::Vector3d> points_m;
    std::vector<Eigen::Vector3d> curve_m; ///< through the points; fewer than two: not drawn
};

/// One link of the arm, drawn as a tube with a ball at its joint. It runs from the origin of its frame along
/// its frame's x axis.
struct ArmLink {
    Eigen::Isometry3d X_World_Link = Eigen::Isometry3d::Identity();
    double length_m = 0.0; ///< >= 0
    double radius_m = 0.0; ///< > 0
};

} // namespace teleta::view3d
