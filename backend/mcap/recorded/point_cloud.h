// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/mcap/cdr_writer.h"

#include <span>

namespace teleta::mcap {

/// Writes a frame as the fields of sensor_msgs/PointCloud2 after the header: a point a taxel with x, y, z in
/// m and what it tells, value, or force_x, force_y, force_z in {s}; all float32. Places without a taxel are
/// left out. values: layout.values() numbers. Thread: any (pure).
void writePoints(CdrWriter& cdr, const core::TaxelLayout& layout, std::span<const float> values);

} // namespace teleta::mcap
