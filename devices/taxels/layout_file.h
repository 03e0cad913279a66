// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/taxels/taxel_grid.h"

#include <optional>
#include <string>

namespace teleta::taxels {

/// What a file says of the frames of an array.
struct LayoutFile {
    TaxelGrid grid;
    std::optional<double> threshold; ///< load from which a taxel counts as touched, in grid.loadUnit()

    void describeKeys(core::Keys& keys);
};

/// Reads where the taxels of an array are: the device file of an array (readTaxels()), or a file that has a
/// table [layout] alone, with the keys that it has in a file of kind "taxels", and may have the key
/// "threshold". Error: notFound, ioFailed, or badInput with line and column. Thread: any.
[[nodiscard]] core::Expected<LayoutFile> readLayout(const std::string& path);

} // namespace teleta::taxels
