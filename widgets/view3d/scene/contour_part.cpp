// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/contour_part.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace teleta::view3d {

namespace {

void keepFinite(std::span<const Eigen::Vector3d> from, std::vector<Eigen::Vector3d>& to,
                Eigen::AlignedBox3d& box) {
    to.clear();
    for (const Eigen::Vector3d& p : from) {
        if (p.allFinite()) {
            to.push_back(p);
            box.extend(p);
        }
    }
}

} // namespace

ContourPart::ContourPart() {
    // Drawn in front: the exploring arm often hides the object.
    m_solids.showThrough();
    m_curve.showThrough();
}

void ContourPart::addTo(vtkRenderer* renderer) {
    renderer->AddActor(m_solids.actor);
    renderer->AddActor(m_curve.actor);
}

void ContourPart::applyColours(const SceneColours& colours) {
    m_colours = colours;
    rebuild();
}

void ContourPart::set(std::span<const Eigen::Vector3d> points_m, std::span<const Eigen::Vector3d> curve_m,
                      std::span<const Eigen::Vector3d> vertices_m) {
    m_box_m.setEmpty();
    keepFinite(points_m, m_points_m, m_box_m);
    keepFinite(curve_m, m_curve_m, m_box_m);
    keepFinite(vertices_m, m_vertices_m, m_box_m);
    rebuild();
}

void ContourPart::rebuild() {
    constexpr double kSmallestPoint_m = 2e-4;
    const double extent_m = m_box_m.isEmpty() ? 0.0 : m_box_m.diagonal().norm();
    const double radius_m = std::max(kSmallestPoint_m, 0.011 * extent_m);
    m_solids.clear();
    m_curve.clear();
    for (const Eigen::Vector3d& p : m_points_m)
        m_solids.sphere(p, radius_m, m_colours.contourPoint.rgb());
    for (const Eigen::Vector3d& p : m_vertices_m)
        m_solids.octahedron(p, 2.2 * radius_m, m_colours.contourVertex.rgb());
    m_curve.polyline(m_curve_m, m_colours.contourCurve.rgb());
    m_solids.finish();
    m_curve.finish();
}

void ContourPart::appendMeshes(std::vector<vtkPolyData*>& meshes) const {
    meshes.push_back(m_solids.data());
    meshes.push_back(m_curve.data());
}

} // namespace teleta::view3d
