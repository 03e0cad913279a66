// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/camera_world.h"
#include "backend/simulation/camera/skin/skin_deformation.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace teleta::simulation {

/// One hole of the shell as it is probed.
struct ProbedHole {
    Eigen::Vector3d p_Sensor_Noted_m; ///< where the person believes to probe, on the skin at rest
    SkinPlace truly;                  ///< where the stick is
    bool mistaken = false;            ///< it is in another hole
};

/// How a person probes all holes of a shell, one after the other, ring by ring: comes down, holds still for
/// half of the time, lifts. A hole that is mistaken is the next one around or along. Play and mistakes have a
/// random stream of their own. Thread: any (const).
class ProbingPlan {
public:
    ProbingPlan(const scene::Probing& probing, const scene::CameraSkin& skin, std::uint64_t seed);

    [[nodiscard]] const std::vector<ProbedHole>& holes() const { return m_holes; }
    /// The hole that it is about at a time; the last one after the end.
    [[nodiscard]] std::size_t holeAt(double time_s) const;
    [[nodiscard]] double duration_s() const { return m_hole_s * static_cast<double>(m_holes.size()); }
    /// The stick as a finger that touches the skin.
    [[nodiscard]] scene::Finger stick() const;

private:
    scene::Probing m_probing;
    double m_hole_s;
    std::vector<ProbedHole> m_holes;
};

} // namespace teleta::simulation
