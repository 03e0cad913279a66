// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/robot/triangle_mesh.h"

#include <array>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr std::uint32_t kFineSides = 32;
constexpr std::uint32_t kFineRings = 16;

std::uint32_t add(TriangleMesh& mesh, const Eigen::Vector3d& point_m, const Eigen::Vector3d& normal) {
    mesh.points_m.emplace_back(point_m.cast<float>());
    mesh.normals.emplace_back(normal.cast<float>());
    mesh.colours.push_back(qRgba(0, 0, 0, 0));
    return static_cast<std::uint32_t>(mesh.points_m.size() - 1);
}

void addTriangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
}

Eigen::Vector3d onCircle(std::uint32_t side) {
    const double turn_rad = 2.0 * std::numbers::pi * side / kFineSides;
    return {std::cos(turn_rad), std::sin(turn_rad), 0.0};
}

} // namespace

void TriangleMesh::append(const TriangleMesh& other, const Eigen::Affine3d& X_This_Other) {
    const auto first = static_cast<std::uint32_t>(points_m.size());
    const Eigen::Matrix3d ofNormals = X_This_Other.linear().inverse().transpose();
    for (const Eigen::Vector3f& point_m : other.points_m)
        points_m.emplace_back((X_This_Other * point_m.cast<double>()).cast<float>());
    for (const Eigen::Vector3f& normal : other.normals)
        normals.emplace_back((ofNormals * normal.cast<double>()).normalized().cast<float>());
    colours.insert(colours.end(), other.colours.begin(), other.colours.end());
    const bool mirrors = X_This_Other.linear().determinant() < 0.0;
    for (std::size_t i = 0; i + 2 < other.corners.size(); i += 3) {
        const std::uint32_t b = other.corners[i + (mirrors ? 2 : 1)];
        const std::uint32_t c = other.corners[i + (mirrors ? 1 : 2)];
        addTriangle(*this, first + other.corners[i], first + b, first + c);
    }
}

void TriangleMesh::colour(QRgb colour) {
    for (QRgb& own : colours)
        own = qAlpha(own) == 0 ? colour : own;
}

TriangleMesh boxMesh(const Eigen::Vector3d& sides_m) {
    TriangleMesh mesh;
    const Eigen::Vector3d half_m = 0.5 * sides_m;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
            const Eigen::Vector3d u = Eigen::Vector3d::Unit((axis + 1) % 3);
            const Eigen::Vector3d v = normal.cross(u);
            std::array<std::uint32_t, 4> corner{};
            for (std::size_t i = 0; i < 4; ++i) {
                const Eigen::Vector3d place =
                    normal + (i == 0 || i == 3 ? -1.0 : 1.0) * u + (i < 2 ? -1.0 : 1.0) * v;
                corner[i] = add(mesh, half_m.cwiseProduct(place), normal);
            }
            addTriangle(mesh, corner[0], corner[1], corner[2]);
            addTriangle(mesh, corner[0], corner[2], corner[3]);
        }
    return mesh;
}

TriangleMesh cylinderMesh(double radius_m, double length_m) {
    TriangleMesh mesh;
    const Eigen::Vector3d up(0.0, 0.0, 0.5 * length_m);
    for (std::uint32_t side = 0; side < kFineSides; ++side) {
        const Eigen::Vector3d here = onCircle(side);
        const Eigen::Vector3d next = onCircle((side + 1) % kFineSides);
        const std::uint32_t a = add(mesh, radius_m * here - up, here);
        const std::uint32_t b = add(mesh, radius_m * next - up, next);
        const std::uint32_t c = add(mesh, radius_m * next + up, next);
        const std::uint32_t d = add(mesh, radius_m * here + up, here);
        addTriangle(mesh, a, b, c);
        addTriangle(mesh, a, c, d);
    }
    for (const double end : {-1.0, 1.0}) {
        const Eigen::Vector3d normal(0.0, 0.0, end);
        const std::uint32_t middle = add(mesh, end * up, normal);
        for (std::uint32_t side = 0; side < kFineSides; ++side) {
            const std::uint32_t here = add(mesh, radius_m * onCircle(side) + end * up, normal);
            const std::uint32_t next =
                add(mesh, radius_m * onCircle((side + 1) % kFineSides) + end * up, normal);
            addTriangle(mesh, middle, end > 0.0 ? here : next, end > 0.0 ? next : here);
        }
    }
    return mesh;
}

TriangleMesh sphereMesh(double radius_m) {
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring <= kFineRings; ++ring) {
        const double polar_rad = std::numbers::pi * ring / kFineRings;
        for (std::uint32_t side = 0; side <= kFineSides; ++side) {
            const Eigen::Vector3d out = std::sin(polar_rad) * onCircle(side % kFineSides) +
                                        std::cos(polar_rad) * Eigen::Vector3d::UnitZ();
            add(mesh, radius_m * out, out);
        }
    }
    for (std::uint32_t ring = 0; ring < kFineRings; ++ring)
        for (std::uint32_t side = 0; side < kFineSides; ++side) {
            const std::uint32_t above = ring * (kFineSides + 1) + side;
            const std::uint32_t below = above + kFineSides + 1;
            if (ring > 0)
                addTriangle(mesh, above, below, above + 1);
            if (ring + 1 < kFineRings)
                addTriangle(mesh, above + 1, below, below + 1);
        }
    return mesh;
}

} // namespace teleta::view3d
