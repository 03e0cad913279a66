// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Camera, lens and handedness from pairs of pixels and points on the cylinder.
[[nodiscard]] Command calibrateCommand();
/// Contacts on the soft tube in a video or live from a camera, one row per contact and frame.
[[nodiscard]] Command trackCommand();

} // namespace teleta::cli
