// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QPainterPath>
#include <QRectF>

class QPainter;

namespace teleta::base {

/// Line icons of the console. They are drawn, not loaded, so they follow the palette and stay sharp at any
/// scale.
enum class Icon {
    operate,
    patterns,
    study,
    calibrate,
    cost,
    settings,
    play,
    pause,
    stepBack,
    stepForward,
    toStart,
    toEnd,
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

/// Draws an icon into a square with the given colour.
void paintIcon(QPainter& painter, const QRectF& square, Icon icon, const QColor& colour);

/// The same as a QIcon, in the application palette's button text colour (disabled: that group's).
[[nodiscard]] QIcon themeIcon(Icon icon);

} // namespace teleta::base
