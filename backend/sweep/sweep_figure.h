// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/figure/svg_canvas.h"
#include "backend/sweep/sweep_plan.h"
#include "backend/sweep/sweep_results.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::sweep {

/// Axes with two values or more, as places in the plan.
[[nodiscard]] std::vector<std::size_t> variedAxes(const SweepPlan& plan);

/// "sd_Nm", "stiffness_N_per_m, radius_m": the last parts of the keys' names, each once.
[[nodiscard]] QString axisTitle(const SweepAxis& axis);
/// A value of an axis with three digits, "200, soft"; what keys have in common once.
[[nodiscard]] QString valueText(const SweepAxis& axis, std::size_t value);

/// A chart of a measure (its place in the results) over the grid, as a picture. One varied axis:
/// its mean with its 95 % interval, and for a number that is no share the band from 5 to 95 % of the runs.
/// Two: the same, a line for each of the second's values when these are no more than six, and a map. More: a
/// map for each value of the others, 24 at most. Empty when nothing is varied or the measure is in no cell.
/// Thread: any (pure).
[[nodiscard]] std::optional<figure::SvgCanvas> sweepFigure(const SweepPlan& plan, const SweepResults& results,
                                                           std::size_t measure);

/// MEASURE.svg for each measure that has a chart. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeSweepFigures(const SweepPlan& plan, const SweepResults& results,
                                                     const std::string& folder);

} // namespace teleta::sweep
