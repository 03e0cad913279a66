// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/marks/trail.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <vtkRenderer.h>

namespace teleta::view3d {

/// Where the tip of an arm was during the last seconds, as a line that fades. World frame. Thread: one.
class TrailPart {
public:
    TrailPart() { m_line.showThrough(); } // the tip is inside of the arm's end
    void addTo(vtkRenderer* renderer) { renderer->AddActor(m_line.actor); }
    void setVisible(bool visible) { m_line.actor->SetVisibility(visible); }
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale) { m_line.setLineWidth(kLine_px, scale); }

    /// time_s: of the arm. Returns whether the picture changes. Many places may come for one picture.
    bool add(const Eigen::Vector3d& p_World_m, double time_s);
    void clear();
    [[nodiscard]] const Trail& trail() const { return m_trail; }
    /// Makes what is drawn anew, if it is shown and changed.
    void draw();

private:
    static constexpr double kLine_px = 3.0;

    Trail m_trail;
    bool m_changed = false; ///< since it was drawn
    SceneColours m_colours;
    Mesh m_line{Mesh::Shading::none, Mesh::Alpha::used};
};

} // namespace teleta::view3d
