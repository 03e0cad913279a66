// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <Eigen/Core>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cstdint>
#include <span>

namespace teleta::view3d {

/// Fills one vtkPolyData with coloured solids and lines, repeatedly, allocating only while it grows. Call
/// clear(), add shapes, then finish(). Colours are per point; so are normals when `withNormals`. Thread: one.
class MeshBuilder {
public:
    /// Whether the colours' alpha counts; a mesh without it is opaque.
    enum class Alpha {
        ignored,
        used,
    };
    explicit MeshBuilder(bool withNormals = true, Alpha alpha = Alpha::ignored);

    [[nodiscard]] vtkPolyData* data() const { return m_data; }
    [[nodiscard]] bool isEmpty() const { return m_points->GetNumberOfPoints() == 0; }

    void clear();
    void finish();

    void sphere(const Eigen::Vector3d& centre, double radius, QRgb colour);
    /// Side of a cone or cylinder between two points, with flat ends where a radius is not 0.
    void cone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radiusFrom, double radiusTo,
              QRgb colour);
    /// An arrow whose head ends at `to`. headLength is shortened when the arrow is shorter than its head.
    void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double shaftRadius, double headLength,
               QRgb colour);
    /// The same bent around an axis of length 1 through `centre`: from a point by an angle, right-handed.
    void turn(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, const Eigen::Vector3d& from,
              double angle_rad, double shaftRadius, double headLength, QRgb colour);
    /// Eight triangles, points on the axes at `radius`.
    void octahedron(const Eigen::Vector3d& centre, double radius, QRgb colour);
    /// Four corners in order, with one normal.
    void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d, QRgb colour);
    /// The same with a colour of each corner, blended between them.
    void quad(const std::array<Eigen::Vector3d, 4>& corners, const std::array<QRgb, 4>& colours);
    /// Points with their normals and colours, and the indices of three points a triangle. otherwise: instead
    /// of a colour with alpha 0.
    void triangles(std::span<const Eigen::Vector3f> points, std::span<const Eigen::Vector3f> normals,
                   std::span<const QRgb> colours, std::span<const std::uint32_t> corners, QRgb otherwise);
    void segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, QRgb colour);
    /// Two ends of their own colours, blended along the way.
    void segment(const Eigen::Vector3d& a, QRgb colourOfA, const Eigen::Vector3d& b, QRgb colourOfB);
    void polyline(std::span<const Eigen::Vector3d> points, QRgb colour, bool closed = false);

private:
    vtkIdType point(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, QRgb colour);
    void disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius, QRgb colour);

    bool m_withNormals;
    bool m_withAlpha;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkFloatArray> m_normals;
    vtkNew<vtkUnsignedCharArray> m_colours;
    vtkNew<vtkCellArray> m_polys;
    vtkNew<vtkCellArray> m_lines;
};

} // namespace teleta::view3d
