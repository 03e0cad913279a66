// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/core/data/taxel_places.h"
#include "backend/mcap/cdr_reader.h"
#include "backend/mcap/cdr_writer.h"

#include <optional>
#include <span>
#include <vector>

namespace teleta::mcap {

/// Writes a frame as the fields of sensor_msgs/PointCloud2 after the header: a point a taxel with x, y, z in
/// m and what it tells, value, or force_x, force_y, force_z in {s}; all float32. Places without a taxel are
/// left out. values: layout.values() numbers. Thread: any (pure).
void writePoints(CdrWriter& cdr, const core::TaxelLayout& layout, std::span<const float> values);

/// Points that tell what taxels do.
struct TaxelPoints {
    int components = 1;
    std::vector<core::TaxelPlace> places;
    std::vector<float> values; ///< components of each place
};

/// Whether a sensor_msgs/PointCloud2 after the header has the fields that readPoints() needs, even if it has
/// no point yet. Nothing: it is damaged before the end of its fields. Thread: any (pure).
[[nodiscard]] std::optional<bool> hasTaxelFields(CdrReader& cdr);

/// Reads the fields of sensor_msgs/PointCloud2 after the header: float32 or float64 x, y, z, and value, or
/// force_x, force_y, force_z; others are passed over. False: it is damaged, has other fields, more than 2^20
/// points, or a place that is not finite or beyond 10 m. Thread: any (pure).
[[nodiscard]] bool readPoints(CdrReader& cdr, TaxelPoints& points);

/// The values on a layout: one of its places after the other, NaN where no taxel is. Empty: they are not as
/// many, or have other components. Thread: any (pure).
[[nodiscard]] std::vector<float> valuesOn(const core::TaxelLayout& layout, const TaxelPoints& points);

} // namespace teleta::mcap
