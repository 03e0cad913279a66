// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace teleta::servo {

/// A rotation as it leaves the program, in the order x, y, z, w of ROS and SciPy, of unit length, with w >=
/// 0; of a half turn, where w is 0, the first component that is not 0 is positive. Eigen's constructor takes
/// w first. R_Parent_Child: maps vectors of the child to the parent; nearly orthonormal. Thread: any (pure).
[[nodiscard]] std::array<double, 4> quaternionXyzw(const Eigen::Matrix3d& R_Parent_Child);

} // namespace teleta::servo
