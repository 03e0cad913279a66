// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::base {

/// A space as wide as a digit in fonts with tabular figures.
inline constexpr QChar kFigureSpace(0x2007);

/// Width of a text in which every digit and figure space is as wide as the widest digit.
[[nodiscard]] double tabularWidth(const QFontMetricsF& metrics, const QString& text);

/// Draws one line with tabular figures, even in a font without them. alignment as for QPainter::drawText.
void drawTabularText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text);

} // namespace teleta::base
