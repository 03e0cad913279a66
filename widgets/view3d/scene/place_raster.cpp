// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/place_raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace teleta::view3d {

PlaceRaster::PlaceRaster(const core::TaxelPlaces& places) {
    double halfX_m = 0.0;
    double halfY_m = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        halfX_m = std::max(halfX_m, std::abs(places[i].x_m) + 0.5 * places.spacing_m(i));
        halfY_m = std::max(halfY_m, std::abs(places[i].y_m) + 0.5 * places.spacing_m(i));
    }
    const double side_m = 2.0 * std::max(halfX_m, halfY_m);
    const double cell_m = std::max(
        std::clamp(side_m / kFineSide, places.pitch_m() / kMostAcross, places.pitch_m() / kLeastAcross),
        side_m / kMostSide);
    const auto cells = [cell_m](double half_m) {
        return std::clamp(static_cast<int>(std::ceil(2.0 * half_m / cell_m - 1e-9)), 1, kMostSide);
    };
    const core::ArrayLayout grid{cells(halfY_m), cells(halfX_m), cell_m};
    m_taxelOf.assign(grid.taxels(), kNone);
    std::vector<double> distance_m(grid.taxels(), std::numeric_limits<double>::infinity());
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (std::size_t taxel = 0; taxel < places.size(); ++taxel) {
        // The cell under its centre is its own, however small the disc.
        const double radius_m = std::max(0.5 * places.spacing_m(taxel), std::sqrt(0.5) * cell_m);
        // Only cells in the square around the disc can be in it.
        const auto within = [&](double middle_m, int count, int& first, int& last) {
            const double centre = middle_m / cell_m + 0.5 * (count - 1);
            const double reach = radius_m / cell_m;
            first = std::clamp(static_cast<int>(std::floor(centre - reach)), 0, count - 1);
            last = std::clamp(static_cast<int>(std::ceil(centre + reach)), 0, count - 1);
        };
        int top = 0, bottom = 0, left = 0, right = 0;
        within(places[taxel].y_m, grid.rows, top, bottom);
        within(places[taxel].x_m, grid.columns, left, right);
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                const std::size_t cell =
                    static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
                const double away_m =
                    std::hypot(grid.x_m(column) - places[taxel].x_m, grid.y_m(row) - places[taxel].y_m);
                if (away_m <= radius_m && away_m < distance_m[cell]) {
                    distance_m[cell] = away_m;
                    m_taxelOf[cell] = taxel;
                }
            }
    }
    m_layout = core::TaxelLayout(grid);
    std::vector<std::uint8_t> absent(m_taxelOf.size());
    std::ranges::transform(m_taxelOf, absent.begin(),
                           [](std::size_t taxel) { return taxel == kNone ? 1 : 0; });
    m_layout.setAbsent(std::move(absent));
}

pipeline::TouchSnapshot PlaceRaster::drawn(const pipeline::TouchSnapshot& snapshot) const {
    pipeline::TouchSnapshot drawn = snapshot;
    drawn.layout = m_layout;
    drawn.load_N.assign(m_taxelOf.size(), 0.0F);
    drawn.dead.assign(m_taxelOf.size(), 0); // no taxel is no dead one
    drawn.labels.assign(snapshot.labels.empty() ? 0 : m_taxelOf.size(), 0);
    drawn.shearX_N.clear();
    drawn.shearY_N.clear();
    for (std::size_t cell = 0; cell < m_taxelOf.size(); ++cell) {
        const std::size_t taxel = m_taxelOf[cell];
        if (taxel == kNone)
            continue;
        drawn.load_N[cell] = snapshot.load_N[taxel];
        drawn.dead[cell] = snapshot.dead.empty() ? 0 : snapshot.dead[taxel];
        if (!drawn.labels.empty())
            drawn.labels[cell] = snapshot.labels[taxel];
    }
    return drawn;
}

} // namespace teleta::view3d
