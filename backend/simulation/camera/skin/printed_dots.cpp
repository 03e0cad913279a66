// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin/printed_dots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace teleta::simulation {

PrintedDots::PrintedDots(const scene::CameraSkin& skin)
    : m_tubeRadius_m(skin.radius_m)
    , m_rings(std::max(1, static_cast<int>(skin.length_m / skin.dotPitch_m)))
    , m_around(std::max(
          3, static_cast<int>(std::lround(2.0 * std::numbers::pi * skin.radius_m / skin.dotPitch_m)))) {
    m_ringStep_m = skin.length_m / m_rings;
    m_firstRing_m = skin.begin_m + 0.5 * m_ringStep_m;
    m_step_rad = 2.0 * std::numbers::pi / m_around;
    for (int ring = 0; ring < m_rings; ++ring) {
        for (int i = 0; i < m_around; ++i)
            m_dots.push_back({{m_step_rad * (i + 0.5 * (ring % 2)), m_firstRing_m + ring * m_ringStep_m},
                              0.5 * skin.dotDiameter_m});
    }
}

void PrintedDots::misprint(const scene::MarkerPrintErrorSpec& error, core::RandomStream& random) {
    for (Dot& dot : m_dots) {
        dot.place.angle_rad += error.sd_m / m_tubeRadius_m * random.normal();
        dot.place.z_m += error.sd_m * random.normal();
        dot.radius_m = std::max(0.0, dot.radius_m * (1.0 + error.sizeShare * random.normal()));
    }
}

PrintedDots::Rim PrintedDots::nearest(const SkinPlace& place) const {
    // A misprint is small against the pitch, so the nearest dot is one of the two nearest of the nearest
    // rings. Several times a pixel: neither a division nor a call of the library.
    const int ring = static_cast<int>((place.z_m - m_firstRing_m) / m_ringStep_m + 1.0) - 1;
    const double angle_rad = wrapped_rad(place.angle_rad);
    const double steps = angle_rad / m_step_rad + m_around;
    Rim best{.distance_m = 1.0};
    double bestAround_m = 1.0;
    double bestAlong_m = 0.0;
    double bestCentre_m = 1.0;
    for (int r = std::max(ring, 0); r <= std::min(ring + 1, m_rings - 1); ++r) {
        int i = static_cast<int>(steps - 0.5 * (r % 2));
        if (i >= m_around)
            i -= m_around;
        const Dot* dots = &m_dots[static_cast<std::size_t>(r * m_around)];
        for (int k = 0; k < 2; ++k) {
            const Dot& dot = dots[i];
            if (++i == m_around)
                i = 0;
            const double around_m = m_tubeRadius_m * wrapped_rad(angle_rad - dot.place.angle_rad);
            const double along_m = place.z_m - dot.place.z_m;
            const double centre_m = std::sqrt(around_m * around_m + along_m * along_m);
            if (centre_m - dot.radius_m < best.distance_m) {
                best.distance_m = centre_m - dot.radius_m;
                bestAround_m = around_m;
                bestAlong_m = along_m;
                bestCentre_m = centre_m;
            }
        }
    }
    best.aroundDirection = bestCentre_m > 0.0 ? bestAround_m / bestCentre_m : 1.0;
    best.alongDirection = bestCentre_m > 0.0 ? bestAlong_m / bestCentre_m : 0.0;
    return best;
}

} // namespace teleta::simulation
