// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/stop_reach.h"

#include "widgets/chrome/stop_button.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>
#include <QWindow>

namespace teleta::chrome {

StopReach::StopReach(StopButton& button)
    : m_button(button) {
    qApp->installEventFilter(this);
    connect(qApp, &QGuiApplication::focusWindowChanged, this, [this](const QWindow* window) {
        if (const StopButton* other = m_substitute;
            other != nullptr && window != nullptr &&
            (window == m_button.window()->windowHandle() || window == other->windowHandle()))
            other->parentWidget()->activateWindow();
    });
}

StopReach::~StopReach() {
    qApp->removeEventFilter(this);
    delete m_substitute;
}

bool StopReach::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        // One press passes several objects: from the second on it is stopped already.
        if (const QWidget* popup = QApplication::activePopupWidget();
            popup != nullptr && !m_button.engaged()) {
            const QPoint global = static_cast<QMouseEvent*>(event)->globalPosition().toPoint();
            if (covers(global) && !popup->geometry().contains(global))
                emit m_button.stopRequested();
        }
        break;
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::WindowBlocked:
    case QEvent::WindowUnblocked:
        // Of any window: a dialog may open another one.
        if (watched->isWidgetType() && static_cast<QWidget*>(watched)->isWindow())
            QMetaObject::invokeMethod(this, &StopReach::follow, Qt::QueuedConnection);
        break;
    case QEvent::Move:
    case QEvent::Resize:
        if (m_substitute != nullptr && (watched == &m_button || watched == m_button.window()))
            QMetaObject::invokeMethod(this, &StopReach::follow, Qt::QueuedConnection);
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void StopReach::follow() {
    QWidget* dialog = QApplication::activeModalWidget();
    const bool needed = dialog != nullptr && m_button.isVisible() && dialog != m_button.window();
    if (const StopButton* other = m_substitute;
        other != nullptr && (!needed || dialog != other->parentWidget()))
        delete other;
    if (!needed)
        return;
    if (m_substitute == nullptr) {
        m_substitute = new StopButton(dialog);
        m_substitute->setWindowFlags(Qt::Tool | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus);
        m_substitute->setAttribute(Qt::WA_ShowWithoutActivating);
        m_substitute->setFocusPolicy(Qt::NoFocus);
        m_substitute->setEngaged(m_button.engaged());
        connect(m_substitute, &StopButton::stopRequested, &m_button, &StopButton::stopRequested);
        connect(m_substitute, &StopButton::releaseRequested, &m_button, &StopButton::releaseRequested);
        connect(&m_button, &StopButton::engagedChanged, m_substitute, &StopButton::setEngaged);
    }
    m_substitute->setGeometry(QRect(m_button.mapToGlobal(QPoint()), m_button.size()));
    m_substitute->show();
    m_substitute->raise();
}

bool StopReach::covers(const QPoint& global) const {
    return m_button.isVisible() && m_button.rect().contains(m_button.mapFromGlobal(global));
}

} // namespace teleta::chrome
