// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/servo_figure/servo_curves.h"

#include <span>

namespace teleta::servo {

/// Size of a figure that no window bounds. px.
inline constexpr double kServoFigureWidth = 820.0;
inline constexpr double kServoFigureHeight = 980.0;

/// Runs in one chart: force, CoP_y, CoC_x, DZMP_y, alpha_z and the array's way over time, what was desired as
/// dashes, where the phases of the first run begin, and above the lanes a row for each run: thin where it is
/// in contact, thick where a limit acts. Crosses: when a weight on the tray is moved, and when DZMP_y is back
/// below 0.5 mm for good. One run alone has its way in x, y and z, beside the felt DZMP_y the true one, and
/// how the array turns about its own z, as commanded and as it does. The axes hold all runs. Redraws Fig. 10,
/// 12 and 14 of the paper, depending on the runs. A wide picture has its lanes in two columns. runs: the
/// first kSeries are drawn. width, height: px, not below 400.
[[nodiscard]] figure::SvgCanvas servoFigure(std::span<const ServoCurves> runs,
                                            double width = kServoFigureWidth,
                                            double height = kServoFigureHeight);

} // namespace teleta::servo
