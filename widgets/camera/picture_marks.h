// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QPointF>
#include <QString>

namespace teleta::camera {

/// The picture of a sensor is grey in both themes; everything drawn over it is light with this outline.
inline constexpr QColor kRim(0, 0, 0, 150);

/// A text that can be read on any grey. at: where its first letter stands.
inline void paintHalo(QPainter& painter, const QPointF& at, const QString& text) {
    QPainterPath path;
    path.addText(at, painter.font(), text);
    painter.strokePath(path, QPen(kRim, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, Qt::white);
}

} // namespace teleta::camera
