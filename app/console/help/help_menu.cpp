// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/help_menu.h"

#include "app/console/help/about.h"
#include "app/console/help/handbook_window.h"
#include "app/console/help/log_window.h"

#include <QMenu>
#include <QWhatsThis>

#include <utility>

namespace teleta::console {

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
    if (m_handbook == nullptr)
        m_handbook = new HandbookWindow(&m_window);
    m_handbook->showPage(page);
    m_handbook->show();
    m_handbook->raise();
    m_handbook->activateWindow();
}

void HelpMenu::openLog() {
    if (m_log == nullptr)
        m_log = new LogWindow(&m_window);
    m_log->show();
    m_log->raise();
    m_log->activateWindow();
}

void HelpMenu::openFirstSteps() {
    openHandbook(QStringLiteral("first-steps"));
}

} // namespace teleta::console
