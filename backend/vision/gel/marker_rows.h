// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/marker_gel.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace teleta::vision {

/// Columns of followed markers in CSV files.
inline constexpr std::array<std::string_view, 12> kMarkerColumns{"frame",  "time_s",    "marker",    "row",
                                                                 "column", "rest_u_px", "rest_v_px", "u_px",
                                                                 "v_px",   "dx_m",      "dy_m",      "found"};

/// Writes all markers of a picture. markers, motions: one each. Rows: a type with the members of
/// core::CsvWriter. A lost marker has no place, and one of a free layout no row and column: NA.
template <typename Rows>
void writeMarkers(Rows& rows, long long frame, double time_s, std::span<const GelMarker> markers,
                  std::span<const GelMotion> motions) {
    const std::optional<double> none;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const GelMarker& marker = markers[i];
        const GelMotion& motion = motions[i];
        rows.integer(frame);
        rows.number(time_s);
        rows.integer(static_cast<long long>(i));
        for (const int place : {marker.grid.row, marker.grid.column}) {
            if (place < 0)
                rows.number(none);
            else
                rows.integer(place);
        }
        rows.number(marker.rest_px.x());
        rows.number(marker.rest_px.y());
        for (const double value : {motion.place_px.x(), motion.place_px.y(), motion.displacement_m.x(),
                                   motion.displacement_m.y()}) {
            if (motion.found)
                rows.number(value);
            else
                rows.number(none);
        }
        rows.integer(motion.found ? 1 : 0);
        rows.endRow();
    }
}

} // namespace teleta::vision
