// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/pipeline/touch/touch_snapshot.h"

#include <cstddef>
#include <vector>

namespace teleta::view3d {

/// Taxels that stand on no grid, as a fine grid of which each has the cells of its disc, as wide as the
/// distance to the next taxel. Cells of no taxel are absent. Heights and normals are left out: what is drawn
/// is the plane of {s}. Thread: any.
class PlaceRaster {
public:
    static constexpr int kMostSide = 120;
    /// Across a usual disc: fewer where the side would have more than kFineSide cells, but not under
    /// kLeastAcross unless it would have more than kMostSide. Frames of more cells take longer.
    static constexpr double kMostAcross = 12.0;
    static constexpr double kLeastAcross = 5.0;
    static constexpr int kFineSide = 60;

    explicit PlaceRaster(const core::TaxelPlaces& places);

    [[nodiscard]] const core::TaxelLayout& layout() const { return m_layout; }
    /// The frame on the grid: loads, dead cells and labels; all else as it is. Cells of no taxel bear no
    /// load.
    [[nodiscard]] pipeline::TouchSnapshot drawn(const pipeline::TouchSnapshot& snapshot) const;

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    core::TaxelLayout m_layout;
    std::vector<std::size_t> m_taxelOf; ///< of each cell, or kNone
};

} // namespace teleta::view3d
