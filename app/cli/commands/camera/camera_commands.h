// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Camera, lens and handedness from pairs of pixels and points on the cylinder.
[[nodiscard]] Command calibrateCommand();
/// Places and displacements of the markers of a flat gel in a video, one row per marker and frame.
[[nodiscard]] Command markersCommand();
/// Contacts on the soft tube in a video or live from a camera, one row per contact and frame.
[[nodiscard]] Command trackCommand();

} // namespace teleta::cli
