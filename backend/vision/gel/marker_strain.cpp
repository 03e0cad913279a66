// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_strain.h"

#include <Eigen/LU>

#include <cmath>

namespace teleta::vision {

void markerStrains(std::span<const GelMarker> markers, std::span<const GelMotion> motions,
                   std::span<const std::vector<std::size_t>> neighbours, std::vector<MarkerStrain>& strains) {
    constexpr double kLeastSpread = 0.02; ///< of places that lie nearly in a row
    strains.assign(markers.size(), {});
    for (std::size_t i = 0; i < markers.size(); ++i) {
        if (!motions[i].found)
            continue;
        Eigen::Vector2d meanRest = markers[i].rest_m;
        Eigen::Vector2d meanMoved = motions[i].displacement_m;
        double count = 1.0;
        for (const std::size_t k : neighbours[i]) {
            if (!motions[k].found)
                continue;
            meanRest += markers[k].rest_m;
            meanMoved += motions[k].displacement_m;
            count += 1.0;
        }
        if (count < 3.0)
            continue;
        meanRest /= count;
        meanMoved /= count;
        Eigen::Matrix2d restRest = Eigen::Matrix2d::Zero();
        Eigen::Matrix2d movedRest = Eigen::Matrix2d::Zero();
        const auto add = [&](std::size_t k) {
            const Eigen::Vector2d rest = markers[k].rest_m - meanRest;
            restRest += rest * rest.transpose();
            movedRest += (motions[k].displacement_m - meanMoved) * rest.transpose();
        };
        add(i);
        for (const std::size_t k : neighbours[i]) {
            if (motions[k].found)
                add(k);
        }
        const double trace = restRest.trace();
        if (!(restRest.determinant() > kLeastSpread * trace * trace))
            continue;
        const Eigen::Matrix2d gradient = movedRest * restRest.inverse();
        strains[i] = {.known = true,
                      .divergence = gradient.trace(),
                      .curl = gradient(1, 0) - gradient(0, 1),
                      .shear = std::hypot(gradient(0, 0) - gradient(1, 1), gradient(0, 1) + gradient(1, 0))};
    }
}

} // namespace teleta::vision
