// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/mesh/mesh_builder.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <array>

class vtkMatrix4x4;

namespace teleta::view3d {

/// The ground: a grid with a round spacing, shown with the scene as its scale.
/// Thread: one.
class GridPart {
public:
    GridPart();
    void addTo(vtkRenderer* renderer) { renderer->AddActor(m_actor.actor); }
    void setVisible(bool visible) { m_actor.actor->SetVisibility(visible); }
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) { m_actor.setLineWidth(1.0, scale); }

    /// Lies under a box and reaches beyond it. A grid that already does and is not much too large stays as it
    /// is, so that it does not twitch while an arm moves. Returns whether it changed.
    bool cover(const Eigen::AlignedBox3d& box_m, bool always);
    [[nodiscard]] double spacing_m() const { return m_spacing_m; }

private:
    void rebuild();

    QRgb m_colour = 0;
    double m_spacing_m = 0.0;
    Eigen::AlignedBox3d m_box_m;
    MeshBuilder m_lines{false};
    MeshActor m_actor;
};

/// The axes of the array's frame, drawn where they leave the sensor's body.
/// Thread: one.
class AxesPart {
public:
    AxesPart();
    void addTo(vtkRenderer* renderer) { renderer->AddActor(m_actor.actor); }
    void setPose(vtkMatrix4x4* X_World_Sensor) { m_actor.actor->SetUserMatrix(X_World_Sensor); }
    void setVisible(bool visible) { m_actor.actor->SetVisibility(visible); }

    /// body_m: distance along each axis at which it leaves the body; length_m: beyond it.
    void rebuild(const Eigen::Vector3d& body_m, double length_m, const SceneColours& colours);
    /// Ends of the arrows x, y, z, in the array's frame.
    [[nodiscard]] const std::array<Eigen::Vector3d, 3>& tips() const { return m_tips; }

private:
    std::array<Eigen::Vector3d, 3> m_tips;
    MeshBuilder m_arrows;
    MeshActor m_actor;
};

} // namespace teleta::view3d
