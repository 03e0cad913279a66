// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/status_glyph.h"

#include "widgets/base/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::base {

using core::DeviceState;

QColor statusColour(DeviceState state, const QPalette& palette) {
    const StatusColours& colours = statusColours(palette);
    return state == DeviceState::live                                         ? colours.live
           : state == DeviceState::stale                                      ? colours.stale
           : state == DeviceState::lost || state == DeviceState::reconnecting ? colours.lost
                                                                              : colours.neutral;
}

QString statusWord(DeviceState state) {
    // In the order of DeviceState.
    static constexpr std::array kWords{
        QT_TRANSLATE_NOOP("DeviceState", "closed"),       QT_TRANSLATE_NOOP("DeviceState", "connecting"),
        QT_TRANSLATE_NOOP("DeviceState", "live"),         QT_TRANSLATE_NOOP("DeviceState", "paused"),
        QT_TRANSLATE_NOOP("DeviceState", "stale"),        QT_TRANSLATE_NOOP("DeviceState", "lost"),
        QT_TRANSLATE_NOOP("DeviceState", "reconnecting"), QT_TRANSLATE_NOOP("DeviceState", "finished")};
    return QCoreApplication::translate("DeviceState", kWords[static_cast<std::size_t>(state)]);
}

QString ageText(double age_s) {
    const double age = std::max(0.0, age_s);
    if (age < 9.95)
        return QCoreApplication::translate("Age", "%1 s").arg(QLocale().toString(age, 'f', 1));
    if (age < 120.0)
        return QCoreApplication::translate("Age", "%1 s").arg(std::floor(age), 0, 'f', 0);
    if (age < 7200.0)
        return QCoreApplication::translate("Age", "%1 min").arg(std::floor(age / 60.0), 0, 'f', 0);
    return QCoreApplication::translate("Age", "%1 h").arg(std::floor(age / 3600.0), 0, 'f', 0);
}

void paintStatusGlyph(QPainter& painter, const QRectF& square, DeviceState state, const QPalette& palette) {
    const QColor colour = statusColour(state, palette);
    const double side = std::min(square.width(), square.height());
    const QPointF centre = square.center();
    const double stroke = std::max(1.5, side * 0.13);
    const double radius = 0.42 * side;
    const auto cross = [&](double reach) {
        painter.drawLine(centre + QPointF(-reach, -reach), centre + QPointF(reach, reach));
        painter.drawLine(centre + QPointF(-reach, reach), centre + QPointF(reach, -reach));
    };

    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const auto setOutline = [&](double width) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
    };
    const double ring = radius - 0.5 * stroke;
    switch (state) {
    case DeviceState::live:
        painter.drawEllipse(centre, radius, radius);
        break;
    case DeviceState::stale: {
        painter.setPen(QPen(colour, 0.6 * stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const double r = radius * 0.95;
        painter.drawPolygon(QPolygonF{centre + QPointF(0.0, -r), centre + QPointF(r, 0.8 * r),
                                      centre + QPointF(-r, 0.8 * r)});
        break;
    }
    case DeviceState::lost:
        painter.drawEllipse(centre, radius, radius);
        painter.setPen(QPen(readableOn(colour), stroke, Qt::SolidLine, Qt::RoundCap));
        cross(0.42 * radius);
        break;
    case DeviceState::reconnecting:
        setOutline(stroke);
        painter.drawEllipse(centre, ring, ring);
        cross(0.35 * radius);
        break;
    case DeviceState::connecting:
        setOutline(stroke);
        painter.drawArc(QRectF(centre - QPointF(ring, ring), QSizeF(2.0 * ring, 2.0 * ring)), 60 * 16,
                        270 * 16);
        break;
    case DeviceState::paused:
        for (const double x : {-0.6 * radius, 0.6 * radius})
            painter.drawRect(QRectF(centre.x() + x - 0.28 * radius, centre.y() - radius * 0.85, 0.56 * radius,
                                    1.7 * radius));
        break;
    case DeviceState::finished:
        painter.drawRect(
            QRectF(centre - QPointF(0.75 * radius, 0.75 * radius), QSizeF(1.5 * radius, 1.5 * radius)));
        break;
    case DeviceState::closed:
        setOutline(0.7 * stroke);
        painter.drawEllipse(centre, ring, ring);
        break;
    }
    painter.restore();
}

} // namespace teleta::base
