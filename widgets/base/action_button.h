// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QPushButton>

namespace teleta::base {

/// A push button for an action: it has the action's text without its letter, its tool tip and whether it can
/// be used. The action outlives it. Thread: GUI.
inline QPushButton* actionButton(QAction& action, QWidget* parent = nullptr) {
    auto* button = new QPushButton(parent);
    button->setAutoDefault(false);
    const auto follow = [button, &action] {
        button->setText(action.text().remove(u'&'));
        button->setToolTip(action.toolTip());
        button->setEnabled(action.isEnabled());
    };
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    QObject::connect(&action, &QAction::changed, button, follow);
    follow();
    return button;
}

} // namespace teleta::base
