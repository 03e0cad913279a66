// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/focus_frame.h"

#include <QPainter>
#include <QWidget>

namespace teleta::base {

void paintFocusFrame(QPainter& painter, const QWidget& view) {
    if (!view.hasFocus())
        return;
    painter.setPen(QPen(view.palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(view.rect().adjusted(0, 0, -1, -1));
}

} // namespace teleta::base
