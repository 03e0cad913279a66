// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"
#include "widgets/view3d/scene/scene_types.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <limits>
#include <span>
#include <vector>

namespace teleta::view3d {

/// The arm in the world frame: bevelled shells between darker joints, a base below the first joint, and a
/// soft shadow on the ground, which shows how high the arm is. Links with an unusable transform, length or
/// radius are left out. Thread: one.
class ArmPart {
public:
    void addTo(vtkRenderer* renderer);
    void applyColours(const SceneColours& colours);

    void set(std::span<const ArmLink> links);
    [[nodiscard]] const std::vector<ArmLink>& links() const { return m_links; }
    /// Whether the arm itself is drawn, or its shadow alone, where something else draws the arm.
    void setShellsShown(bool shown);
    /// Height of the ground, m; NaN: there is none, and neither base nor shadow.
    void setGround(double z_m);
    /// Of the links alone.
    [[nodiscard]] const Eigen::AlignedBox3d& box_m() const { return m_box_m; }
    void appendMeshes(std::vector<vtkPolyData*>& meshes) const { meshes.push_back(m_solids.data()); }

private:
    void rebuild();
    void drawLink(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m);
    void drawBase(const Eigen::Vector3d& shoulder, double radius_m);
    void drawShadow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m);

    std::vector<ArmLink> m_links;
    bool m_shellsShown = true;
    double m_ground_m = std::numeric_limits<double>::quiet_NaN();
    Eigen::AlignedBox3d m_box_m;
    SceneColours m_colours;
    Mesh m_solids{Mesh::Shading::smooth};
    Mesh m_shadow{Mesh::Shading::none, Mesh::Alpha::used};
};

} // namespace teleta::view3d
