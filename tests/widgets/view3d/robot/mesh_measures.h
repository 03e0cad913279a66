// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/robot/triangle_mesh.h"

#include <Eigen/Geometry>

namespace teleta::view3d {

/// The volume inside a closed surface whose triangles turn anticlockwise from outside, by the divergence
/// theorem: the sum of a . (b x c) / 6.
inline double volume_m3(const TriangleMesh& mesh) {
    double sum = 0.0;
    const auto at = [&](std::size_t i) { return mesh.points_m[mesh.corners[i]].cast<double>().eval(); };
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3)
        sum += at(i).dot(at(i + 1).cross(at(i + 2))) / 6.0;
    return sum;
}

/// Whether each corner's normal looks to the side from which its triangle turns anticlockwise.
inline bool normalsLookOut(const TriangleMesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
        const Eigen::Vector3f& a = mesh.points_m[mesh.corners[i]];
        const Eigen::Vector3f out =
            (mesh.points_m[mesh.corners[i + 1]] - a).cross(mesh.points_m[mesh.corners[i + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k)
            if (!(mesh.normals[mesh.corners[i + k]].dot(out) > 0.0F))
                return false;
    }
    return true;
}

inline Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& point_m : mesh.points_m)
        box.extend(point_m.cast<double>());
    return box;
}

} // namespace teleta::view3d
