// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/controls/form_row.h"

#include <QFormLayout>
#include <QLabel>

namespace teleta::base {

void addFormRow(QFormLayout& form, const QString& text, QLayout* fields, QWidget* buddy) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    form.addRow(label, fields);
}

} // namespace teleta::base
