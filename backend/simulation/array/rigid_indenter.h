// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/simulation/array/keyframe_motion.h"

namespace teleta::simulation {

/// How deep a rigid body reaches under the free surface of the array; u along its axis, v across it.
///   sphere:    d - r^2/(R + sqrt(R^2 - r^2)),  r < R,  r^2 = u^2 + v^2
///   cylinder:  d - v^2/(R + sqrt(R^2 - v^2)),  |v| < R,  |u| < L/2
///   box edge:  d - |v|,                        |u| < L/2
///   punch:     d,                              |u| < L/2,  |v| < W/2
/// and 0 where that is negative. A body that is deeper than its radius goes on with upright walls.
/// Thread: one.
class RigidIndenter {
public:
    explicit RigidIndenter(const scene::IndenterShape& shape)
        : m_shape(shape) {}

    void moveTo(const Pose& pose);

    [[nodiscard]] const Pose& pose() const { return m_pose; }
    [[nodiscard]] bool touches() const { return m_pose.depth_m > 0.0; }

    /// Half size, along x and y, of the box around pose() in which the body is under the surface; 0 without
    /// contact.
    [[nodiscard]] double halfWidthX_m() const { return m_halfX_m; }
    [[nodiscard]] double halfWidthY_m() const { return m_halfY_m; }

    /// Mean depth over a cell of width x height about (x, y). Walls and the slopes across the body are
    /// averaged over the cell, so that the result varies smoothly while the body moves and turns.
    [[nodiscard]] double meanPenetration_m(double x_m, double y_m, double width_m, double height_m) const;

private:
    scene::IndenterShape m_shape;
    Pose m_pose;
    double m_cos = 1.0;
    double m_sin = 0.0;
    double m_halfU_m = 0.0; ///< half length of the contact along the body's axis
    double m_halfV_m = 0.0; ///< and across it
    double m_halfX_m = 0.0;
    double m_halfY_m = 0.0;
};

} // namespace teleta::simulation
