// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QRegularExpression>
#include <QStringList>
#include <QWidget>

namespace teleta::test {

/// Labels of a form that show a literal "&" because they have no buddy to focus.
inline QStringList labelsWithBareMnemonic(const QWidget& form) {
    static const QRegularExpression mnemonic(QStringLiteral("&[^&\\s]"));
    QStringList bare;
    for (const QLabel* label : form.findChildren<QLabel*>()) {
        if (label->buddy() == nullptr && label->text().contains(mnemonic))
            bare << label->text();
    }
    return bare;
}

} // namespace teleta::test
