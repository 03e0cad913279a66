// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/scene_run/effect_ablation.h"

namespace teleta::cli {

/// Prints what each effect of a scene does to its measures: one row an effect and measure.
///   effect, measure, mean, spread, mean_without, change, change_per_spread, seeds_that_differ, moves,
///   own_time_s, run_s, run_with_all_s
/// Measures that no effect changes are left out. Spread: standard deviation over the seeds.
[[nodiscard]] core::Expected<void> printAblation(const scene_run::Ablation& ablation,
                                                 const RowOptions& options);

} // namespace teleta::cli
