// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/taxels/taxel_grid.h"

#include <string>

namespace teleta::taxels {

/// Reads where the taxels of an array are: the device file of an array (readTaxels()), or a file that has a
/// table [layout] alone, with the keys that it has in a file of kind "taxels". Error: notFound, ioFailed, or
/// badInput with line and column. Thread: any.
[[nodiscard]] core::Expected<TaxelGrid> readTaxelGrid(const std::string& path);

} // namespace teleta::taxels
