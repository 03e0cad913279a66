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

/// What a simulated world has around the arm, as translucent solids with their edges; what is round is solid.
/// World frame. Items without an axis and with fewer than three corners, or with numbers that are not finite,
/// are left out. Thread: one.
class SceneryPart {
public:
    /// A solid reaches so far above and below the plane of its outline.
    static constexpr double kHalfHeight_m = 0.015;

    SceneryPart();
    void addTo(vtkRenderer* renderer);
    void setVisible(bool visible);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) { m_edges.setLineWidth(1.5, scale); }

    /// Returns whether anything changed.
    bool set(std::span<const SceneryItem> items);
    [[nodiscard]] const std::vector<SceneryItem>& items() const { return m_items; }
    [[nodiscard]] bool isVisible() const { return m_edges.actor->GetVisibility() != 0; }
    /// Of all items; empty when they are not shown.
    [[nodiscard]] Eigen::AlignedBox3d box_m() const;
    /// Where the name of an item belongs: the middle of an outline, the end of an axis.
    [[nodiscard]] static Eigen::Vector3d placeOfName_m(const SceneryItem& item);

private:
    void rebuild();

    std::vector<SceneryItem> m_items;
    SceneColours m_colours;
    Mesh m_solids{Mesh::Shading::flat};
    Mesh m_edges{Mesh::Shading::none};
    Mesh m_rounds{Mesh::Shading::smooth};
};

} // namespace teleta::view3d
