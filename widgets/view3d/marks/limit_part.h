// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/marks/limit_watch.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"
#include "widgets/view3d/scene/scene_types.h"

#include <QColor>

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <span>
#include <vector>

namespace teleta::view3d {

/// A joint near the end of its range.
struct LimitMark {
    JointDial dial;
    QColor colour;
    bool isAtEnd = false;
    Eigen::Vector3d p_World_Label; ///< outside of the dial, at the present angle
};

/// Dials of the joints that are near a limit: an arc over the range, a bar at each end, a pointer at the
/// present angle, and what is left between it and the limit. In front of the arm. Thread: one.
class LimitPart {
public:
    LimitPart();
    void addTo(vtkRenderer* renderer);
    void setVisible(bool visible);
    void applyColours(const SceneColours& colours);
    void applyPixelScale(double scale);

    /// All joints of the arm, always in the same order. Returns whether anything that is drawn changed.
    bool set(std::span<const JointDial> dials);
    [[nodiscard]] const std::vector<LimitMark>& marks() const { return m_marks; }

private:
    void rebuild();
    void draw(const LimitMark& mark);

    std::vector<LimitWatch> m_watches; ///< one a joint
    std::vector<LimitMark> m_marks;
    SceneColours m_colours;
    Mesh m_lines{Mesh::Shading::none};
    Mesh m_left{Mesh::Shading::none, Mesh::Alpha::used};
};

} // namespace teleta::view3d
