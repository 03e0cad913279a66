// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace teleta::contact {

/// Raw moments of a frame and of its binary image, in taxels.
struct FrameMoments {
    double sum = 0.0;  ///< sum of the loads in range
    double sumX = 0.0; ///< sum of load times column, counted from the centre of the array
    double sumY = 0.0; ///< sum of load times row, counted from the centre of the array
    std::int64_t active = 0;
    std::int64_t x = 0, y = 0; ///< sums over the active taxels of column and row, counted from 0; exact
    std::int64_t xx = 0, xy = 0, yy = 0; ///< sums of their products; exact
    float peak = 0.0F;
    bool unusable = false; ///< a value is negative, infinite or NaN; all other members are then invalid
};

/// Geometry of a frame whose rows are stride values apart; the values behind the columns of a row are 0.
struct FrameShape {
    int rows = 0;
    int columns = 0;
    int stride = 0; ///< >= columns and >= kMomentLanes
};

/// Columns that are summed in parallel.
constexpr int kMomentLanes = 4;

/// Computes all moments in one pass. threshold: > 0; a value is active when it is at least this. activeOnly:
/// the load sums run over active values only. Thread: any (pure); allocates nothing.
[[nodiscard]] FrameMoments momentsOf(const float* values, const FrameShape& shape, float threshold,
                                     bool activeOnly);

} // namespace teleta::contact
