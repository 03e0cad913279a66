// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <span>
#include <vector>

namespace teleta::view3d {

/// Contour explored by touch: contact points, the spline through them, vertices. In the world frame. Points
/// that are not finite are left out. Thread: one.
class ContourPart {
public:
    ContourPart();
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) { m_curve.setLineWidth(3.0, scale); }

    void set(std::span<const Eigen::Vector3d> points_m, std::span<const Eigen::Vector3d> curve_m,
             std::span<const Eigen::Vector3d> vertices_m);
    [[nodiscard]] const Eigen::AlignedBox3d& box_m() const { return m_box_m; }
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;

private:
    void rebuild();

    std::vector<Eigen::Vector3d> m_points_m;
    std::vector<Eigen::Vector3d> m_curve_m;
    std::vector<Eigen::Vector3d> m_vertices_m;
    Eigen::AlignedBox3d m_box_m;
    SceneColours m_colours;
    Mesh m_solids{Mesh::Shading::smooth};
    Mesh m_curve{Mesh::Shading::none};
};

} // namespace teleta::view3d
