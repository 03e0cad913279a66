// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/hold_button.h"

#include <QEvent>
#include <QMouseEvent>

namespace teleta::base {

HoldButton::HoldButton(QWidget* parent)
    : QPushButton(parent) {
    setFocusPolicy(Qt::NoFocus);
    setAutoDefault(false);
}

void HoldButton::letGo() {
    setDown(false);
    if (!m_held)
        return;
    m_held = false;
    emit heldChanged(false, {});
}

void HoldButton::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (event->button() != Qt::LeftButton || m_held)
        return;
    m_held = true;
    setDown(true);
    emit heldChanged(true, event->modifiers());
}

void HoldButton::mouseMoveEvent(QMouseEvent* event) {
    if (!rect().contains(event->position().toPoint()))
        letGo();
}

void HoldButton::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        letGo();
}

void HoldButton::hideEvent(QHideEvent* event) {
    letGo();
    QPushButton::hideEvent(event);
}

void HoldButton::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        letGo();
    QPushButton::changeEvent(event);
}

} // namespace teleta::base
