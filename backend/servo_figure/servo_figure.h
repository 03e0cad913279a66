// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/servo_figure/servo_curves.h"

#include <span>

namespace teleta::servo_figure {

/// Size of a figure that is not drawn in a window; px.
inline constexpr double kServoFigureWidth = 820.0;
inline constexpr double kServoFigureHeight = 980.0;

/// Draws runs in one chart: force, CoP_y, CoC_x, DZMP_y, alpha_z and the path of the array over time, desired
/// values dashed. Marks show where the phases of the first run begin. Above the lanes each run has a bar that
/// is thin while in contact and thick while a limit acts. Crosses mark when a weight on the tray is moved and
/// when |DZMP_y| has fallen below 0.5 mm for good. A single run is drawn with its path in x, y and z, the
/// true DZMP_y beside the measured one, and the turn of the array about its own z, commanded and measured.
/// The axes fit all runs. Depending on the runs this redraws Fig. 10, 12 or 14 of the paper. A wide figure
/// has its lanes in two columns. runs: the first kSeries are drawn. width, height: px, >= 400. Thread: any
/// (pure).
[[nodiscard]] figure::SvgCanvas servoFigure(std::span<const ServoCurves> runs,
                                            double width = kServoFigureWidth,
                                            double height = kServoFigureHeight);

} // namespace teleta::servo_figure
