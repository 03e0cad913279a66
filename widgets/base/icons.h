// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QPainterPath>
#include <QRectF>

#include <initializer_list>

class QPainter;

namespace teleta::base {

/// The console's line icons, drawn at run time in the colours of the palette.
enum class Icon {
    operate,
    patterns,
    study,
    calibrate,
    cost,
    plot,
    play,
    pause,
    stepBack,
    stepForward,
    toStart,
    loop,
    info,
    warning,
    error,
    close,
    scene,
    recording,
    sensor,
    mark,
    strips,
    more,
};

/// The parts of an icon, on a grid of 24 units.
struct IconDrawing {
    QPainterPath strokes;
    QPainterPath fills;
    double stroke = 1.8; ///< width of the lines
};
/// Adds a line through points to a path.
void addLine(QPainterPath& path, std::initializer_list<QPointF> points, bool closed = false);

/// Draws an icon into a square with the given colour.
void paintIcon(QPainter& painter, const QRectF& square, const IconDrawing& drawing, const QColor& colour);
void paintIcon(QPainter& painter, const QRectF& square, Icon icon, const QColor& colour);

/// A drawing as a QIcon, in the application palette's button text colour (disabled: that group's).
[[nodiscard]] QIcon themeIcon(const IconDrawing& drawing);
[[nodiscard]] QIcon themeIcon(Icon icon);

} // namespace teleta::base
