// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <QRectF>

#include <algorithm>

namespace teleta::tactile {

inline const QColor kCasing(0x00, 0x00, 0x00, 0xb0); ///< around marks, visible on yellow and on blue
inline const QColor kMark(0xff, 0xff, 0xff);

inline void drawArrowHead(QPainter& painter, const QPointF& tip, const QPointF& direction, double size) {
    const QPointF side(-direction.y(), direction.x());
    painter.drawPolygon(QPolygonF{tip, tip - direction * size + side * (0.4 * size),
                                  tip - direction * size - side * (0.4 * size)});
}

inline void drawCross(QPainter& painter, const QPointF& centre, double radius) {
    painter.drawLine(centre + QPointF(-radius, -radius), centre + QPointF(radius, radius));
    painter.drawLine(centre + QPointF(-radius, radius), centre + QPointF(radius, -radius));
}

inline void drawHatch(QPainter& painter, const QRectF& rect, double spacing) {
    for (double offset = 0.5 * spacing; offset < rect.width() + rect.height(); offset += spacing) {
        const double x0 = std::max(0.0, offset - rect.height());
        const double x1 = std::min(offset, rect.width());
        painter.drawLine(QPointF(rect.left() + x0, rect.top() + offset - x0),
                         QPointF(rect.left() + x1, rect.top() + offset - x1));
    }
}

} // namespace teleta::tactile
