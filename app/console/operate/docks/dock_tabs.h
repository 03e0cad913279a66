// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>
#include <QPointer>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace teleta::console {

/// What the tabs of docks that lie upon each other do: the tab is the title, so that the title bar below it
/// goes; its menu maximises, floats and closes the dock, a double click maximises it, and dragging it out of
/// the row makes the dock float. Thread: GUI.
class DockTabs : public QObject {
    Q_OBJECT

public:
    /// Watches the docks of a window, which it belongs to.
    explicit DockTabs(QMainWindow* docks);

signals:
    void maximiseRequested(QDockWidget* dock);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void adopt(QTabBar* tabs);
    void showTitlesOnce();
    void openMenu(const QTabBar& tabs, const QPoint& place);
    [[nodiscard]] QDockWidget* dockAt(const QTabBar& tabs, int tab) const;

    QMainWindow* m_docks;
    QPointer<QDockWidget> m_pressed; ///< whose tab the mouse holds
    bool m_asked = false;            ///< the titles are looked at soon
};

} // namespace teleta::console
