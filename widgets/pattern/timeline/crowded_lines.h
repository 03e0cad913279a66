// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPainter;
class QPen;
class QPolygonF;

namespace teleta::editor {

/// Fills what lies between two lines with rising x that begin and end together, with the painter's brush and
/// without a pen; where they cross, on both sides. Qt's rasteriser takes time with the square of the edges
/// that cross a row of pixels: a shape with many corners is filled piece by piece, a slice of its width at a
/// time. Neither line is empty. Thread: that of the painter.
void fillBetween(QPainter& painter, const QPolygonF& one, const QPolygonF& other);

/// Strokes a line, piece by piece for the same reason when it has many corners; its dashes then begin anew
/// with each piece. The pen must be opaque. Leaves the painter with this pen and without a brush. Thread:
/// that of the painter.
void strokeLine(QPainter& painter, const QPolygonF& line, const QPen& pen);

} // namespace teleta::editor
