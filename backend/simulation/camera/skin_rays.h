// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/camera/skin/skin_deformation.h"

#include <Eigen/Core>

#include <vector>

namespace teleta::simulation {

/// Follows rays from a lens inside the tube to the first point of its deformed skin, in eight steps through
/// the depth in which the skin can be, so that a press hides what is behind it, and from there by a search
/// that keeps the point between two others. A ray is looked at only where a press reaches its way through
/// that depth. Thread: one. Source: N. Anderson, A. Bjoerck, A new high order method of regula falsi type
/// (1973).
class SkinRays {
public:
    /// deformation: must outlive the rays.
    SkinRays(const SkinDeformation& deformation, const Eigen::Vector3d& lens_m);

    /// rest: where the skin that the ray meets is at rest; the ray would meet the undeformed tube at a place,
    /// angle in -pi .. pi, z beyond the lens. False: no press changes what it meets.
    bool follow(const SkinPlace& place, SkinPlace& rest);

private:
    /// A press, and the square of its distance along the ray: c + 2 b u + a u^2.
    struct Chord {
        const SkinDeformation::Press* press = nullptr;
        double b = 0.0, c = 0.0;
    };
    /// Along the ray: from the undeformed tube, u = 0, to where no skin can be, u = 1.
    struct Way {
        double around_m = 0.0; ///< of the whole way
        double along_m = 0.0;
        double enters = 0.0;    ///< distance of the end from the lens, as a share
        double square_m2 = 0.0; ///< of its length on the surface
        Eigen::Vector2d way_m =
            Eigen::Vector2d::Zero(); ///< across the axis, from the lens to the undeformed tube
    };
    struct Reaching {
        const SkinDeformation::Press* press = nullptr;
        double angle_rad = 0.0; ///< of its centre, in -pi .. pi
    };
    [[nodiscard]] Way wayTo(const SkinPlace& place) const;
    /// How far the ray is above the skin.
    [[nodiscard]] double above_m(const Way& way, double u) const;
    /// Where the ray meets the skin; negative: where it is at rest. The presses reach it between from and to.
    [[nodiscard]] double meets(const Way& way, double from, double to) const;

    Eigen::Vector3d m_lens_m;
    double m_radius_m;
    double m_inner_m;      ///< radius that no skin reaches
    double m_skinEnds;     ///< u beyond which no skin can be
    double m_mostAround_m; ///< upper bound of a way's length around
    bool m_onAxis;
    std::vector<Reaching> m_presses;
    std::vector<Chord> m_chords;
};

} // namespace teleta::simulation
