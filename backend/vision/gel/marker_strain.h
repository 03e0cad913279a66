// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/marker_gel.h"

#include <span>
#include <vector>

namespace teleta::vision {

/// How the surface of the gel is strained about one marker.
struct MarkerStrain {
    bool known = false;      ///< from at least three places that do not lie in a row
    double divergence = 0.0; ///< change of area, as a share
    double curl = 0.0;       ///< twice the turn, in rad; from x to y
    double shear = 0.0;      ///< largest shear strain, >= 0
};

/// Fits d = d0 + G (x - x0) to the displacements d of each found marker and its found neighbours by least
/// squares: divergence = Gxx + Gyy, curl = Gyx - Gxy, shear = hypot(Gxx - Gyy, Gxy + Gyx).
/// Thread: any (pure).
void markerStrains(std::span<const GelMarker> markers, std::span<const GelMotion> motions,
                   std::span<const std::vector<std::size_t>> neighbours, std::vector<MarkerStrain>& strains);

} // namespace teleta::vision
