// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/quaternion_order.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace teleta::servo {

std::array<double, 4> quaternionXyzw(const Eigen::Matrix3d& R_Parent_Child) {
    const Eigen::Quaterniond q = Eigen::Quaterniond(R_Parent_Child).normalized();
    const std::array<double, 4> wFirst{q.w(), q.x(), q.y(), q.z()};
    const auto leading = std::ranges::find_if(wFirst, [](double value) { return value != 0.0; });
    const double sign = leading != wFirst.end() && *leading < 0.0 ? -1.0 : 1.0;
    // 0.0 takes the sign off a zero.
    return {sign * q.x() + 0.0, sign * q.y() + 0.0, sign * q.z() + 0.0, sign * q.w() + 0.0};
}

} // namespace teleta::servo
