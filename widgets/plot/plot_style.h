// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QPicture>

class QCustomPlot;

namespace teleta::plot {

/// Applies the colours of a palette to the background, axes and grid of a plot, and a font to its labels and
/// titles. Thread: GUI.
void stylePlot(QCustomPlot& plot, const QPalette& colours, const QFont& font);

/// Pen of the grid lines. Thread: any (pure).
[[nodiscard]] QColor gridColour(const QPalette& colours);

/// The plot as a vector picture, for files. Thread: GUI.
[[nodiscard]] QPicture pictureOf(QCustomPlot& plot);

} // namespace teleta::plot
