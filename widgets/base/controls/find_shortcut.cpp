// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/find_shortcut.h"

#include <QAction>
#include <QLineEdit>

namespace teleta::base {

void findBy(QLineEdit* search, QWidget* page) {
    auto* find = new QAction(page);
    find->setShortcut(QKeySequence::Find);
    page->addAction(find);
    QObject::connect(find, &QAction::triggered, search, [search] {
        search->setFocus(Qt::ShortcutFocusReason);
        search->selectAll();
    });
}

} // namespace teleta::base
