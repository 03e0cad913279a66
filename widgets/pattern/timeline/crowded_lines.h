// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;
class QPen;
class QPolygonF;

namespace teleta::pattern {

/// Fills the area between two lines with rising x and common ends, also where they cross, with the painter's
/// brush and without a pen. The time of Qt's rasteriser grows with the square of the edges that cross a row
/// of pixels, so a shape with many corners is filled in slices of its width. one, other: not empty. Thread:
/// that of the painter.
void fillBetween(QPainter& painter, const QPolygonF& one, const QPolygonF& other);

/// Strokes a line. For the same reason a line with many corners is stroked in pieces, and its dashes restart
/// with each piece. pen: opaque. Leaves the painter with this pen and without a brush. Thread: that of the
/// painter.
void strokeLine(QPainter& painter, const QPolygonF& line, const QPen& pen);

} // namespace teleta::pattern
