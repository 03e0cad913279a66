// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/json_document.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/recording/recording_types.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pipeline {

// How the layout of an array is recorded: by the shape and the columns of its stream, and in its details.
// Thread: any (pure).

/// The shape of a frame: taxels x 3 of vectors, rows x columns of loads on a grid, else taxels.
[[nodiscard]] std::vector<std::size_t> shapeOf(const core::TaxelLayout& layout);

/// t0_x, t0_y, t0_z, t1_x, ... of vectors; none of loads, which are t0, t1, ... everywhere.
[[nodiscard]] std::vector<recording::Column> componentColumns(const core::TaxelLayout& layout,
                                                              const std::string& unit);

/// Members of the details: "pitch_m" of a grid of loads on squares, which is all that older versions know; of
/// others "components", "rows", "columns", "pitch_x_m", "pitch_y_m", or "positions_m" and "normals"; "mask".
[[nodiscard]] nlohmann::ordered_json layoutJson(const core::TaxelLayout& layout);

/// The layout of a stream of this shape, by the details that the reader reads. Nothing: a shape that no array
/// has. Errors of single values are the reader's.
[[nodiscard]] std::optional<core::TaxelLayout> readLayout(core::JsonReader& reader,
                                                          const std::vector<std::size_t>& shape);

/// The layout of a stream; nothing: it is no array, or not described as one.
[[nodiscard]] std::optional<core::TaxelLayout> layoutOf(const recording::StreamInfo& stream);

} // namespace teleta::pipeline
