// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <array>
#include <limits>

class vtkMatrix4x4;

namespace teleta::view3d {

/// The ground: a grid with a round spacing, which is also the scale of the scene. Thread: one.
class GridPart {
public:
    void addTo(vtkRenderer* renderer) { renderer->AddActor(m_lines.actor); }
    void setVisible(bool visible) { m_lines.actor->SetVisibility(visible); }
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) { m_lines.setLineWidth(1.0, scale); }

    /// Places the grid under a box and beyond it. A grid that is large enough, but not much too large, is
    /// kept, so that it does not change while an arm moves. Returns whether it changed.
    bool cover(const Eigen::AlignedBox3d& box_m, bool always);
    [[nodiscard]] double spacing_m() const { return m_spacing_m; }
    /// NaN while it covers nothing.
    [[nodiscard]] double height_m() const {
        return m_box_m.isEmpty() ? std::numeric_limits<double>::quiet_NaN() : m_box_m.min().z();
    }

private:
    void rebuild();

    QRgb m_colour = 0;
    double m_spacing_m = 0.0;
    Eigen::AlignedBox3d m_box_m;
    Mesh m_lines{Mesh::Shading::none};
};

/// The axes of the array's frame, drawn from where they leave the sensor's body. Thread: one.
class AxesPart {
public:
    void addTo(vtkRenderer* renderer) { renderer->AddActor(m_arrows.actor); }
    void setPose(vtkMatrix4x4* X_World_Sensor) { m_arrows.actor->SetUserMatrix(X_World_Sensor); }
    void setVisible(bool visible) { m_arrows.actor->SetVisibility(visible); }

    /// body_m: distance along each axis to the body's surface; length_m: beyond it.
    void rebuild(const Eigen::Vector3d& body_m, double length_m, const SceneColours& colours);
    /// Ends of the arrows x, y, z, in the array's frame.
    [[nodiscard]] const std::array<Eigen::Vector3d, 3>& tips() const { return m_tips; }

private:
    std::array<Eigen::Vector3d, 3> m_tips;
    Mesh m_arrows{Mesh::Shading::smooth};
};

} // namespace teleta::view3d
