// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

class QMenu;
class QWidget;

namespace teleta::console {

class HandbookWindow;
class LogWindow;

/// The menu Help: handbook (F1, at the current page), What's This, shortcuts, log, about. Thread: GUI.
class HelpMenu : public QObject {
    Q_OBJECT

public:
    /// page: handbook page for what the window shows now.
    HelpMenu(QWidget& window, std::function<QString()> page);

    void fill(QMenu& menu);
    void openHandbook(const QString& page);
    void openFirstSteps();

private:
    void openLog();

    QWidget& m_window;
    std::function<QString()> m_page;
    HandbookWindow* m_handbook = nullptr; ///< created when first opened; owned by the window
    LogWindow* m_log = nullptr;           ///< likewise
};

} // namespace teleta::console
