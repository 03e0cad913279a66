// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace teleta::view3d {

/// A surface of triangles, m.
struct TriangleMesh {
    std::vector<Eigen::Vector3f> points_m;
    std::vector<Eigen::Vector3f> normals; ///< as many as points; of length 1
    std::vector<QRgb> colours;            ///< as many as points; alpha 0: nobody says which
    std::vector<std::uint32_t> corners;   ///< indices of points, three a triangle

    [[nodiscard]] std::size_t triangles() const { return corners.size() / 3; }
    /// Adds another one, placed by a transform with an inverse, which may scale and mirror.
    void append(const TriangleMesh& other, const Eigen::Affine3d& X_This_Other);
    /// Gives all points without a colour this one.
    void colour(QRgb colour);
};

/// Closed solids around the origin; a cylinder lies along z. Sizes: m, > 0.
[[nodiscard]] TriangleMesh boxMesh(const Eigen::Vector3d& sides_m);
[[nodiscard]] TriangleMesh cylinderMesh(double radius_m, double length_m);
[[nodiscard]] TriangleMesh sphereMesh(double radius_m);

} // namespace teleta::view3d
