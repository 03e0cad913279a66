// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>

namespace teleta::test {

/// Moves the mouse to a point of a widget from somewhere else: no event comes when it is there already.
inline void hover(QWidget* widget, const QPoint& point) {
    QTest::mouseMove(widget, QPoint(1, 1));
    QTest::mouseMove(widget, point);
}

/// Turns the wheel over a widget by whole notches. True when the widget took the event.
inline bool turnWheel(QWidget* widget, const QPointF& position, int notches,
                      Qt::KeyboardModifiers modifiers = {}) {
    constexpr int kNotch = 120;
    QWheelEvent event(position, widget->mapToGlobal(position), QPoint(), QPoint(0, kNotch * notches),
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    event.ignore();
    QApplication::sendEvent(widget, &event);
    return event.isAccepted();
}

} // namespace teleta::test
