// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QRectF>
#include <QSizeF>

class QPainter;

namespace teleta::touch {

/// Colour of safe (green) and of danger (red); always with the word and the shape.
[[nodiscard]] QColor safetyColour(bool safe, const QPalette& palette);

/// The shape alone: safe is a disc with a tick, danger a triangle with an exclamation mark.
void paintSafetyShape(QPainter& painter, const QRectF& square, bool safe, const QColor& colour);

/// Shape and word in a frame of the same colour.
[[nodiscard]] QSizeF safetySignSize(const QFont& font, bool safe);
void paintSafetySign(QPainter& painter, const QRectF& rect, const QFont& font, bool safe,
                     const QPalette& palette);

} // namespace teleta::touch
