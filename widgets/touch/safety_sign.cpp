// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/safety_sign.h"

#include "widgets/base/theme.h"
#include "widgets/touch/touch_texts.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace teleta::touch {

QColor safetyColour(bool safe, const QPalette& palette) {
    const base::StatusColours& colours = base::statusColours(palette);
    return safe ? colours.live : colours.lost;
}

void paintSafetyShape(QPainter& painter, const QRectF& square, bool safe, const QColor& colour) {
    constexpr double kGrid = 24.0;
    const double side = std::min(square.width(), square.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(square.center() - QPointF(0.5 * side, 0.5 * side));
    painter.scale(side / kGrid, side / kGrid);
    const QPen ink(base::readableOn(colour), 2.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setBrush(colour);
    if (safe) {
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(QPointF(12.0, 12.0), 10.5, 10.5);
        QPainterPath tick(QPointF(7.0, 12.4));
        tick.lineTo(10.6, 16.0);
        tick.lineTo(17.0, 8.6);
        painter.strokePath(tick, ink);
    } else {
        painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(QPolygonF({{12.0, 2.5}, {22.5, 21.0}, {1.5, 21.0}}));
        painter.setPen(ink);
        painter.drawLine(QPointF(12.0, 9.0), QPointF(12.0, 14.2));
        painter.drawPoint(QPointF(12.0, 18.2));
    }
    painter.restore();
}

QSizeF safetySignSize(const QFont& font, bool safe) {
    const QFontMetricsF metrics(base::bold(font));
    return {metrics.horizontalAdvance(TouchTexts::safety(safe)) + 2.2 * metrics.height(),
            1.5 * metrics.height()};
}

void paintSafetySign(QPainter& painter, const QRectF& rect, const QFont& font, bool safe,
                     const QPalette& palette) {
    const QColor colour = safetyColour(safe, palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(base::mixed(palette.color(QPalette::Base), colour, 0.12));
    const double radius = 0.2 * rect.height();
    painter.drawRoundedRect(rect.adjusted(0.75, 0.75, -0.75, -0.75), radius, radius);
    const double side = 0.62 * rect.height();
    const QRectF shape(rect.left() + 0.35 * rect.height(), rect.center().y() - 0.5 * side, side, side);
    paintSafetyShape(painter, shape, safe, colour);
    painter.setFont(base::bold(font));
    painter.setPen(colour);
    painter.drawText(QRectF(shape.right(), rect.top(), rect.right() - shape.right(), rect.height()),
                     Qt::AlignCenter, TouchTexts::safety(safe));
    painter.restore();
}

} // namespace teleta::touch
