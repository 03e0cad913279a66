// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/mesh_builder.h"

#include <Eigen/Geometry>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr int kSides = 20;
constexpr int kRings = 10;

/// Points of the unit circle; the last is the first again.
const std::array<Eigen::Vector2d, kSides + 1>& unitCircle() {
    static const auto circle = [] {
        std::array<Eigen::Vector2d, kSides + 1> points;
        for (int i = 0; i <= kSides; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i % kSides) / kSides;
            points[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
        }
        return points;
    }();
    return circle;
}

} // namespace

MeshBuilder::MeshBuilder(bool withNormals, Alpha alpha)
    : m_withNormals(withNormals)
    , m_withAlpha(alpha == Alpha::used) {
    m_points->SetDataTypeToFloat();
    m_colours->SetName("colour");
    m_colours->SetNumberOfComponents(m_withAlpha ? 4 : 3);
    m_normals->SetName("normal");
    m_normals->SetNumberOfComponents(3);
    m_data->SetPoints(m_points);
    m_data->SetPolys(m_polys);
    m_data->SetLines(m_lines);
    m_data->GetPointData()->SetScalars(m_colours);
    if (withNormals)
        m_data->GetPointData()->SetNormals(m_normals);
}

void MeshBuilder::clear() {
    m_points->SetNumberOfPoints(0);
    m_normals->SetNumberOfTuples(0);
    m_colours->SetNumberOfTuples(0);
    m_polys->Reset();
    m_lines->Reset();
}

void MeshBuilder::finish() {
    m_points->Modified();
    m_normals->Modified();
    m_colours->Modified();
    m_polys->Modified();
    m_lines->Modified();
    m_data->Modified();
}

vtkIdType MeshBuilder::point(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, QRgb colour) {
    const vtkIdType id = m_points->InsertNextPoint(p.data());
    if (m_withNormals)
        m_normals->InsertNextTuple3(normal.x(), normal.y(), normal.z());
    // Without alpha only the first three are taken.
    const std::array<unsigned char, 4> rgba = {
        static_cast<unsigned char>(qRed(colour)), static_cast<unsigned char>(qGreen(colour)),
        static_cast<unsigned char>(qBlue(colour)), static_cast<unsigned char>(qAlpha(colour))};
    m_colours->InsertNextTypedTuple(rgba.data());
    return id;
}

void MeshBuilder::sphere(const Eigen::Vector3d& centre, double radius, QRgb colour) {
    const auto& circle = unitCircle();
    vtkIdType first = m_points->GetNumberOfPoints();
    for (int ring = 0; ring <= kRings; ++ring) {
        const double polar = std::numbers::pi * ring / kRings;
        for (int side = 0; side <= kSides; ++side) {
            const Eigen::Vector2d& c = circle[static_cast<std::size_t>(side)];
            const Eigen::Vector3d out(std::sin(polar) * c.x(), std::sin(polar) * c.y(), std::cos(polar));
            point(centre + radius * out, out, colour);
        }
    }
    for (int ring = 0; ring < kRings; ++ring, first += kSides + 1) {
        for (int side = 0; side < kSides; ++side) {
            const vtkIdType a = first + side;
            const vtkIdType below = a + kSides + 1;
            m_polys->InsertNextCell({a, below, below + 1, a + 1});
        }
    }
}

void MeshBuilder::triangles(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3f> normals,
                            std::span<const QRgb> colours, std::span<const std::uint32_t> corners,
                            QRgb otherwise) {
    const vtkIdType first = m_points->GetNumberOfPoints();
    for (std::size_t i = 0; i < points.size(); ++i)
        point(points[i].cast<double>(), normals[i].cast<double>(),
              qAlpha(colours[i]) == 0 ? otherwise : colours[i]);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        m_polys->InsertNextCell({first + corners[i], first + corners[i + 1], first + corners[i + 2]});
}

void MeshBuilder::disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius,
                       QRgb colour) {
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    const vtkIdType first = m_points->GetNumberOfPoints();
    m_polys->InsertNextCell(kSides);
    for (int side = 0; side < kSides; ++side) {
        const Eigen::Vector2d& c = unitCircle()[static_cast<std::size_t>(side)];
        point(centre + radius * (c.x() * u + c.y() * v), normal, colour);
        m_polys->InsertCellPoint(first + side);
    }
}

void MeshBuilder::cone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom,
                       double radiusTo, QRgb colour) {
    const Eigen::Vector3d along = to - from;
    const double length = along.norm();
    if (!(length > 0.0))
        return;
    const Eigen::Vector3d w = along / length;
    const Eigen::Vector3d u = w.unitOrthogonal();
    const Eigen::Vector3d v = w.cross(u);
    const double slope = (radiusFrom - radiusTo) / length;
    const vtkIdType first = m_points->GetNumberOfPoints();
    for (const Eigen::Vector2d& c : unitCircle()) {
        const Eigen::Vector3d out = c.x() * u + c.y() * v;
        const Eigen::Vector3d normal = (out + slope * w).normalized();
        point(from + radiusFrom * out, normal, colour);
        point(to + radiusTo * out, normal, colour);
    }
    for (vtkIdType side = 0; side < kSides; ++side) {
        const vtkIdType a = first + 2 * side;
        m_polys->InsertNextCell({a, a + 2, a + 3, a + 1});
    }
    if (radiusFrom > 0.0)
        disc(from, -w, radiusFrom, colour);
    if (radiusTo > 0.0)
        disc(to, w, radiusTo, colour);
}

void MeshBuilder::arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double shaftRadius,
                        double headLength, QRgb colour) {
    const Eigen::Vector3d along = to - from;
    const double length = along.norm();
    if (!(length > 0.0))
        return;
    const double head = std::min(headLength, length);
    const Eigen::Vector3d neck = to - head / length * along;
    if (head < length)
        cone(from, neck, shaftRadius, shaftRadius, colour);
    cone(neck, to, 2.4 * shaftRadius, 0.0, colour);
}

void MeshBuilder::turn(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                       const Eigen::Vector3d& from, double angle_rad, double shaftRadius, double headLength,
                       QRgb colour) {
    constexpr int kSteps = 24;
    const Eigen::Vector3d arm = from - centre;
    const double radius = (arm - arm.dot(axis) * axis).norm();
    if (!(radius > 0.0) || angle_rad == 0.0)
        return;
    const auto at = [&](double angle) -> Eigen::Vector3d {
        return centre + Eigen::AngleAxisd(angle, axis) * arm;
    };
    const double head = std::min(headLength, radius * std::abs(angle_rad));
    const double neck_rad = angle_rad - std::copysign(head / radius, angle_rad);
    Eigen::Vector3d begin = from;
    for (int i = 1; i <= kSteps; ++i) {
        const Eigen::Vector3d end = at(neck_rad * i / kSteps);
        cone(begin, end, shaftRadius, shaftRadius, colour);
        begin = end;
    }
    cone(begin, at(angle_rad), 2.4 * shaftRadius, 0.0, colour);
}

void MeshBuilder::octahedron(const Eigen::Vector3d& centre, double radius, QRgb colour) {
    for (const double sx : {-1.0, 1.0}) {
        for (const double sy : {-1.0, 1.0}) {
            for (const double sz : {-1.0, 1.0}) {
                const Eigen::Vector3d normal = Eigen::Vector3d(sx, sy, sz).normalized();
                vtkIdType x = point(centre + Eigen::Vector3d(sx * radius, 0, 0), normal, colour);
                vtkIdType y = point(centre + Eigen::Vector3d(0, sy * radius, 0), normal, colour);
                const vtkIdType z = point(centre + Eigen::Vector3d(0, 0, sz * radius), normal, colour);
                if (sx * sy * sz < 0.0)
                    std::swap(x, y); // keep the outside counter-clockwise
                m_polys->InsertNextCell({x, y, z});
            }
        }
    }
}

void MeshBuilder::quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d, QRgb colour) {
    quad({a, b, c, d}, {colour, colour, colour, colour});
}

void MeshBuilder::quad(const std::array<Eigen::Vector3d, 4>& corners, const std::array<QRgb, 4>& colours) {
    const Eigen::Vector3d normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    const vtkIdType first = m_points->GetNumberOfPoints();
    for (std::size_t i = 0; i < corners.size(); ++i)
        point(corners[i], normal, colours[i]);
    m_polys->InsertNextCell({first, first + 1, first + 2, first + 3});
}

void MeshBuilder::segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, QRgb colour) {
    segment(a, colour, b, colour);
}

void MeshBuilder::segment(const Eigen::Vector3d& a, QRgb colourOfA, const Eigen::Vector3d& b,
                          QRgb colourOfB) {
    const Eigen::Vector3d none = Eigen::Vector3d::UnitZ();
    const vtkIdType first = point(a, none, colourOfA);
    point(b, none, colourOfB);
    m_lines->InsertNextCell({first, first + 1});
}

void MeshBuilder::polyline(std::span<const Eigen::Vector3d> points, QRgb colour, bool closed) {
    if (points.size() < 2)
        return;
    const vtkIdType first = m_points->GetNumberOfPoints();
    const int count = static_cast<int>(points.size());
    m_lines->InsertNextCell(closed ? count + 1 : count);
    for (const Eigen::Vector3d& p : points)
        m_lines->InsertCellPoint(point(p, Eigen::Vector3d::UnitZ(), colour));
    if (closed)
        m_lines->InsertCellPoint(first);
}

} // namespace teleta::view3d
