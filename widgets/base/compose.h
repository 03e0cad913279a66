// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QLatin1String>
#include <QWidget>

#include <initializer_list>
#include <utility>

namespace teleta::base {

/// A new widget with an object name, for tests and style sheets. arguments: of its constructor, the parent
/// among them. Thread: GUI.
template <typename Widget, typename... Arguments>
[[nodiscard]] Widget* named(const char* name, Arguments&&... arguments) {
    auto* widget = new Widget(std::forward<Arguments>(arguments)...);
    widget->setObjectName(QLatin1String(name));
    return widget;
}

/// Appends widgets to a layout. Thread: GUI.
inline void addWidgets(QLayout* layout, std::initializer_list<QWidget*> widgets) {
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
}

/// Adds a row of several widgets to a form. Without a buddy its label would show the & of a key. Thread: GUI.
inline void addFormRow(QFormLayout& form, const QString& text, QLayout* fields, QWidget* buddy) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    form.addRow(label, fields);
}

} // namespace teleta::base
