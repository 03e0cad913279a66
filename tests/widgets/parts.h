// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QString>

namespace teleta::test {

/// The part of a widget with that object name; fails the program when there is
/// none.
template <typename Part = QPushButton>
Part* part(const QWidget& widget, const char* name) {
    auto* found = widget.findChild<Part*>(QLatin1String(name));
    if (found == nullptr)
        qFatal("no part %s", name);
    return found;
}

/// What the label of that object name says.
inline QString textOf(const QWidget& widget, const char* label) {
    return part<QLabel>(widget, label)->text();
}

} // namespace teleta::test
