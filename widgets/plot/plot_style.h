// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QPicture>

class QCustomPlot;

namespace teleta::plot {

/// Gives ground, axes and grid of a plot the colours of a palette, and its numbers and titles a font.
/// Thread: GUI.
void stylePlot(QCustomPlot& plot, const QPalette& colours, const QFont& font);

/// The lines that stand behind a plot's curves. Thread: any (pure).
[[nodiscard]] QColor gridColour(const QPalette& colours);

/// The plot as it is now, for files: lines and texts, no pixels. Thread: GUI.
[[nodiscard]] QPicture pictureOf(QCustomPlot& plot);

} // namespace teleta::plot
