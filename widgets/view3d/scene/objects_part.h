// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"
#include "widgets/view3d/scene/scene_types.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <span>
#include <vector>

namespace teleta::view3d {

/// The objects that were found before: the outline of each in a colour of its own, with its contact points,
/// larger where it is marked. In the world frame. Points that are not finite are left out. Thread: one.
class ObjectsPart {
public:
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) {
        m_curves.setLineWidth(2.0, scale);
        m_marked.setLineWidth(5.0, scale);
    }

    void set(std::span<const DrawnObject> objects);
    /// Those that have a finite point.
    [[nodiscard]] const std::vector<DrawnObject>& objects() const { return m_objects; }
    [[nodiscard]] QColor colourOf(const DrawnObject& object) const;
    [[nodiscard]] const Eigen::AlignedBox3d& box_m() const { return m_box_m; }
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const;

private:
    void rebuild();

    std::vector<DrawnObject> m_objects;
    Eigen::AlignedBox3d m_box_m;
    SceneColours m_colours;
    Mesh m_points{Mesh::Shading::smooth};
    Mesh m_curves{Mesh::Shading::none};
    Mesh m_marked{Mesh::Shading::none};
};

} // namespace teleta::view3d
