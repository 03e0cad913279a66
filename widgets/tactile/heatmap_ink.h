// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>
#include <QPolygonF>

namespace teleta::tactile {

inline const QColor kCasing(0x00, 0x00, 0x00, 0xb0); ///< around marks, visible on yellow and on blue
inline const QColor kMark(0xff, 0xff, 0xff);

inline void drawArrowHead(QPainter& painter, const QPointF& tip, const QPointF& direction, double size) {
    const QPointF side(-direction.y(), direction.x());
    painter.drawPolygon(QPolygonF{tip, tip - direction * size + side * (0.4 * size),
                                  tip - direction * size - side * (0.4 * size)});
}

} // namespace teleta::tactile
