// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QPicture>

class QCPAxis;
class QCustomPlot;

namespace teleta::plot {

/// Applies the colours of a palette to the background, axes and grid of a plot, and a font to its texts.
/// Thread: GUI.
void stylePlot(QCustomPlot& plot, const QPalette& colours, const QFont& font);

/// The same for one axis, for those beside the usual two.
void styleAxis(QCPAxis& axis, const QPalette& colours, const QFont& font);

/// Takes fewer ticks on the left and the bottom axis where the plot is small, so that their labels stay
/// apart. Thread: GUI.
void keepTicksApart(QCustomPlot& plot);

/// Pen of the grid lines. Thread: any (pure).
[[nodiscard]] QColor gridColour(const QPalette& colours);

/// The plot as a vector picture, for files. Thread: GUI.
[[nodiscard]] QPicture pictureOf(QCustomPlot& plot);

/// Version of QCustomPlot that was compiled in: "2.1.0". Thread: any (pure).
[[nodiscard]] QString libraryVersion();

} // namespace teleta::plot
