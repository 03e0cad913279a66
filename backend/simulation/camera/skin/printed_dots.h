// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/scene/camera_world.h"
#include "backend/scene/effects.h"
#include "backend/simulation/camera/skin/skin_deformation.h"

#include <vector>

namespace teleta::simulation {

/// The dots that are printed on the skin: rings along z whose dots are offset by half a step from ring to
/// ring. Thread: any (const).
class PrintedDots {
public:
    struct Dot {
        SkinPlace place;
        double radius_m = 0.0;
    };

    explicit PrintedDots(const scene::CameraSkin& skin);

    /// A misprint: moves and resizes each dot. Errors that are small against the step between dots.
    void misprint(const scene::MarkerPrintErrorSpec& error, core::RandomStream& random);

    /// Distance from the rim of the nearest dot, negative inside it, and the direction away from its centre.
    struct Rim {
        double distance_m = 0.0;
        double aroundDirection = 0.0; ///< of a unit vector
        double alongDirection = 0.0;
    };
    /// place: on the skin at rest.
    [[nodiscard]] Rim nearest(const SkinPlace& place) const;

    [[nodiscard]] const std::vector<Dot>& dots() const { return m_dots; } ///< ring by ring
    [[nodiscard]] int rings() const { return m_rings; }
    [[nodiscard]] int around() const { return m_around; }

private:
    double m_tubeRadius_m;
    double m_firstRing_m;
    double m_ringStep_m;
    double m_step_rad;
    int m_rings;
    int m_around;
    std::vector<Dot> m_dots;
};

} // namespace teleta::simulation
