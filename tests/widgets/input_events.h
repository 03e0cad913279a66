// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QLineEdit>
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

/// Double-clicks a place of a picture and types into the line that opens in the view; empty text: deletes
/// what stands there.
inline void typeAt(QWidget* view, QWidget* picture, const QPoint& place, const QString& text) {
    QTest::mouseDClick(picture, Qt::LeftButton, {}, place);
    QTest::mouseRelease(picture, Qt::LeftButton, {}, place); // a double click alone leaves the button down
    auto* edit = view->findChild<QLineEdit*>();
    QVERIFY(edit);
    edit->selectAll();
    if (text.isEmpty())
        QTest::keyClick(edit, Qt::Key_Delete);
    else
        QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    QTRY_VERIFY(!view->findChild<QLineEdit*>());
}

} // namespace teleta::test
