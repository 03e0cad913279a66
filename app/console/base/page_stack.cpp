// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/page_stack.h"

#include <QScrollArea>

namespace teleta::console {

void PageStack::addPage(QWidget* page) {
    auto* room = new QScrollArea(this);
    room->setFrameShape(QFrame::NoFrame);
    room->setFocusPolicy(Qt::NoFocus); // keys are the page's
    room->setWidgetResizable(true);
    room->setWidget(page);
    addWidget(room);
}

void PageStack::showPage(QWidget* page) {
    for (int i = 0; i < count(); ++i)
        if (static_cast<QScrollArea*>(widget(i))->widget() == page)
            setCurrentIndex(i);
}

} // namespace teleta::console
