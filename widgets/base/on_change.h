// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QWidget>

#include <functional>
#include <initializer_list>

namespace teleta::base {

/// Calls update when the widget gets one of these events (LanguageChange, PaletteChange ...). Thread: GUI.
void onChange(QWidget* widget, std::function<void()> update, std::initializer_list<QEvent::Type> kinds);

/// The same for a member function of the widget.
template <typename Widget, typename Owner>
void onChange(Widget* widget, void (Owner::*update)(), std::initializer_list<QEvent::Type> kinds) {
    onChange(
        widget, [widget, update] { (widget->*update)(); }, kinds);
}

/// Calls retranslate now and whenever the language changes.
template <typename Widget, typename Owner>
void keepTranslated(Widget* widget, void (Owner::*retranslate)()) {
    (widget->*retranslate)();
    onChange(widget, retranslate, {QEvent::LanguageChange});
}

} // namespace teleta::base
