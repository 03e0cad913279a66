// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

namespace teleta::cli {

/// Runs a scene, a possible study or a ladder over a grid of settings, here or on a cluster with Slurm.
[[nodiscard]] Command sweepCommand();

} // namespace teleta::cli
