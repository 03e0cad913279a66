// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/frames/frame_request.h"
#include "devices/taxels/taxel_grid.h"

namespace teleta::taxels {

/// The array of a layout file, for frames in files that do not say where their taxels are. Thread: any
/// (pure).
[[nodiscard]] frames::KnownArray knownArray(TaxelGrid grid);

} // namespace teleta::taxels
