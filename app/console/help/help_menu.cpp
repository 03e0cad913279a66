// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/help_menu.h"

#include "app/console/help/about.h"
#include "app/console/help/handbook_window.h"
#include "app/console/help/log_window.h"
#include "widgets/chrome/stop_button.h"

#include <QMenu>
#include <QScreen>
#include <QWhatsThis>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

/// More than the frame of a window takes at its sides, and with its title at its top.
constexpr int kFrame_px = 48;

/// Beside the main window where the screen has room, else over it, but clear of STOP, which is at its lower
/// right. Where the desktop places windows, this is a wish.
void placeClearOfStop(QWidget& window, const QWidget& main) {
    const auto* stop = main.findChild<chrome::StopButton*>();
    if (stop == nullptr)
        return;
    const QRect room = main.screen()->availableGeometry();
    const QRect taken = main.frameGeometry();
    const int width = window.width() + kFrame_px;
    if (taken.right() + width <= room.right()) {
        window.move(taken.right() + 1, taken.top());
    } else if (taken.left() - width >= room.left()) {
        window.move(taken.left() - width, taken.top());
    } else {
        const int left = std::max(room.left(), taken.center().x() - width / 2);
        const int top = std::max(room.top(), main.geometry().top()) + kFrame_px;
        const int lowest = stop->mapToGlobal(QPoint()).y() - kFrame_px;
        window.setGeometry(left, top, std::min(window.width(), room.right() - left),
                           std::min(window.height(), lowest - top));
    }
}

} // namespace

HelpMenu::HelpMenu(QWidget& window, std::function<QString()> page)
    : QObject(&window)
    , m_window(window)
    , m_page(std::move(page)) {
}

void HelpMenu::fill(QMenu& menu) {
    menu.addAction(tr("&Handbook"), QKeySequence::HelpContents, this, [this] { openHandbook(m_page()); });
    menu.addAction(tr("&First steps"), this, &HelpMenu::openFirstSteps);
    menu.addSeparator();
    menu.addAction(QWhatsThis::createAction(&menu));
    menu.addAction(tr("&Shortcuts"), this, [this] { openShortcuts(&m_window); });
    menu.addAction(tr("&Log"), this, &HelpMenu::openLog);
    menu.addSeparator();
    menu.addAction(tr("&About TeleTA Console"), this, [this] { openAbout(&m_window); });
}

void HelpMenu::openHandbook(const QString& page) {
    if (m_handbook == nullptr) {
        m_handbook = new HandbookWindow(&m_window);
        placeClearOfStop(*m_handbook, m_window);
    }
    m_handbook->showPage(page);
    m_handbook->show();
    m_handbook->raise();
    m_handbook->activateWindow();
}

void HelpMenu::openLog() {
    if (m_log == nullptr) {
        m_log = new LogWindow(&m_window);
        placeClearOfStop(*m_log, m_window);
    }
    m_log->show();
    m_log->raise();
    m_log->activateWindow();
}

void HelpMenu::openFirstSteps() {
    openHandbook(QStringLiteral("first-steps"));
}

} // namespace teleta::console
