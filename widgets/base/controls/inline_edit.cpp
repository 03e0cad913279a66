// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/inline_edit.h"

#include <QFocusEvent>
#include <QKeyEvent>

#include <algorithm>

namespace teleta::base {

InlineEdit::InlineEdit(QWidget* parent, const QRect& place, const QString& text)
    : QLineEdit(text, parent) {
    const int height = std::max(place.height(), sizeHint().height());
    setGeometry(std::clamp(place.left(), 0, std::max(0, parent->width() - place.width())),
                std::clamp(place.center().y() - height / 2, 0, std::max(0, parent->height() - height)),
                place.width(), height);
    selectAll();
    show();
    setFocus();
}

void InlineEdit::finish(bool commit) {
    if (m_done)
        return;
    m_done = true; // hiding it loses the focus, which would finish a second time
    if (commit && isModified())
        emit committed(text());
    hide();
    parentWidget()->setFocus();
    deleteLater();
}

void InlineEdit::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        finish(true);
        break;
    case Qt::Key_Escape:
        finish(false);
        break;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void InlineEdit::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason)
        finish(true);
}

} // namespace teleta::base
