// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/docks/dock_tabs.h"

#include "widgets/base/theme.h"

#include <QChildEvent>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMouseEvent>
#include <QTabBar>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

/// Takes the place of a title bar, and no room.
class NoTitle : public QWidget {
public:
    using QWidget::QWidget;

    [[nodiscard]] QSize sizeHint() const override { return {0, 0}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }
};

} // namespace

DockTabs::DockTabs(QMainWindow* docks)
    : QObject(docks)
    , m_docks(docks) {
    docks->installEventFilter(this);
}

QDockWidget* DockTabs::dockAt(const QTabBar& tabs, int tab) const {
    if (tab < 0)
        return nullptr;
    for (auto* dock : m_docks->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
        if (!dock->isHidden() && !dock->isFloating() && dock->windowTitle() == tabs.tabText(tab))
            return dock;
    return nullptr;
}

void DockTabs::adopt(QTabBar* tabs) {
    // Names stay whole; where they do not fit, arrows scroll through them.
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
    tabs->installEventFilter(this);
    connect(tabs, &QTabBar::tabBarDoubleClicked, this, [this, tabs](int tab) {
        if (QDockWidget* dock = dockAt(*tabs, tab))
            emit maximiseRequested(dock);
    });
}

void DockTabs::openMenu(const QTabBar& tabs, const QPoint& place) {
    const QPointer<QDockWidget> dock = dockAt(tabs, tabs.tabAt(place));
    if (dock == nullptr)
        return;
    auto* menu = new QMenu(m_docks);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Maximise"), this, [this, dock] {
        if (dock)
            emit maximiseRequested(dock);
    });
    menu->addAction(tr("&Float"), this, [dock] {
        if (dock)
            dock->setFloating(true);
    });
    menu->addAction(tr("&Close"), this, [dock] {
        if (dock)
            dock->close();
    });
    menu->popup(tabs.mapToGlobal(place));
}

void DockTabs::showTitlesOnce() {
    m_asked = false;
    for (auto* dock : m_docks->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        const QList<QDockWidget*> others = m_docks->tabifiedDockWidgets(dock);
        const bool isTab = !dock->isFloating() && std::ranges::any_of(others, [](const QDockWidget* other) {
            return !other->isHidden();
        });
        QWidget* title = dock->titleBarWidget();
        if (isTab == (title != nullptr))
            continue;
        dock->setTitleBarWidget(isTab ? new NoTitle(dock) : nullptr);
        delete title;
    }
}

bool DockTabs::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_docks) {
        if (event->type() == QEvent::ChildPolished) {
            // Qt makes the tabs of docks that lie upon each other.
            if (auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child()))
                adopt(tabs);
        } else if (event->type() == QEvent::LayoutRequest && !std::exchange(m_asked, true)) {
            QMetaObject::invokeMethod(this, &DockTabs::showTitlesOnce, Qt::QueuedConnection);
        }
        return false;
    }
    auto* tabs = qobject_cast<QTabBar*>(watched);
    if (tabs == nullptr)
        return false;
    if (event->type() == QEvent::ContextMenu) {
        // One from the keyboard is for the tab that is shown, wherever the mouse or the input is.
        const auto* menu = static_cast<QContextMenuEvent*>(event);
        openMenu(*tabs, menu->reason() == QContextMenuEvent::Keyboard
                            ? tabs->tabRect(tabs->currentIndex()).center()
                            : menu->pos());
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        m_pressed = mouse->button() == Qt::LeftButton
                        ? dockAt(*tabs, tabs->tabAt(mouse->position().toPoint()))
                        : nullptr;
    } else if (event->type() == QEvent::MouseButtonRelease) {
        m_pressed = nullptr;
    } else if (event->type() == QEvent::MouseMove && m_pressed != nullptr) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const int away = base::em(tabs, 1.5);
        const int y = mouse->position().toPoint().y();
        if (y > -away && y < tabs->height() + away)
            return false;
        QDockWidget* dock = std::exchange(m_pressed, nullptr);
        const QPoint at = mouse->globalPosition().toPoint();
        QMouseEvent release(QEvent::MouseButtonRelease, mouse->position(), mouse->globalPosition(),
                            Qt::LeftButton, Qt::NoButton, mouse->modifiers());
        QCoreApplication::sendEvent(tabs, &release); // the row lets go of it
        dock->setFloating(true);
        dock->move(at - QPoint(base::em(tabs, 2), base::em(tabs, 0.5)));
        return true;
    }
    return false;
}

} // namespace teleta::console
