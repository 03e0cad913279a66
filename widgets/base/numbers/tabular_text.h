// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <QString>

class QPainter;

namespace teleta::base {

/// As wide as a digit of a font with tabular figures.
inline constexpr QChar kFigureSpace(0x2007);

/// Width of a text whose digits and figure spaces all take the room of the widest digit.
[[nodiscard]] double tabularWidth(const QFontMetricsF& metrics, const QString& text);

/// Draws one line with tabular figures, whatever the font's own digits are. alignment as for
/// QPainter::drawText.
void drawTabularText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment, const QString& text);

} // namespace teleta::base
