// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/view3d/mesh/mesh_actor.h"
#include "widgets/view3d/scene/scene_colours.h"
#include "widgets/view3d/scene/scene_types.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <optional>

namespace teleta::view3d {

/// Moment of an array's loads about their centre of contact, on the array and in its frame; Nm. The object
/// presses with the force f along -z at the centre of pressure:
///   M = (CoP - CoC) x (0, 0, -f) = f (-DZMP_x, DZMP_y, 0)
/// Empty where a feature is not defined. Source: tactile servoing paper, section 3.
[[nodiscard]] std::optional<Eigen::Vector3d> momentOf_Nm(const contact::TactileFeatures& features);

/// The force on an arm as its joints or a sensor at its wrist tell it, as a straight arrow that ends where it
/// acts, and the moment of the loads on a flat array as an arrow that turns about it. Lengths have the scale
/// of the contacts' arrows; without an array a measured force has a scale of its own. Thread: one.
class WrenchPart {
public:
    void addTo(vtkRenderer* renderer);
    void setForcesShown(bool shown) { m_force.actor->SetVisibility(shown); }
    void setMomentsShown(bool shown) { m_moment.actor->SetVisibility(shown); }
    [[nodiscard]] bool areForcesShown() const { return m_force.actor->GetVisibility() != 0; }
    [[nodiscard]] bool areMomentsShown() const { return m_moment.actor->GetVisibility() != 0; }
    void applyColours(const SceneColours& colours) { m_colours = colours; }

    /// The range of the moments follows the newest frame. Call once a frame.
    void take(const pipeline::TouchSnapshot& snapshot);
    void setForce(const std::optional<DrawnForce>& force);
    [[nodiscard]] const std::optional<DrawnForce>& force() const { return m_drawnForce; }
    /// On an array that is bent the centres are not levers of the force: no moment.
    void setArrayBent(bool bent) { m_bent = bent; }
    /// Draws both anew for the scene as it is.
    void draw(const TouchScene& scene);

    // As drawn the last time; empty: not drawn.
    [[nodiscard]] const std::optional<Eigen::Vector3d>& forceTail() const { return m_forceTail; }
    [[nodiscard]] const std::optional<Eigen::Vector3d>& momentHead() const { return m_momentHead; }
    [[nodiscard]] double moment_Nm() const { return m_moment_Nm; }
    /// Force of the longest arrow.
    [[nodiscard]] double forceRange_N(const TouchScene& scene) const;
    /// Moment of the longest arrow.
    [[nodiscard]] double momentRange_Nm() const { return m_momentRange.high(); }

private:
    void drawForce(const TouchScene& scene, double arrow_m, double mark_m);
    void drawMoment(const TouchScene& scene);

    std::optional<DrawnForce> m_drawnForce;
    base::CalmRange m_momentRange{1.0};
    base::CalmRange m_measuredRange{5.0}; ///< N
    double m_leastRange_Nm = 0.0;
    std::optional<Eigen::Vector3d> m_forceTail;
    std::optional<Eigen::Vector3d> m_momentHead;
    double m_moment_Nm = 0.0;
    bool m_bent = false;
    SceneColours m_colours;
    Mesh m_force{Mesh::Shading::smooth};
    Mesh m_moment{Mesh::Shading::smooth};
};

} // namespace teleta::view3d
