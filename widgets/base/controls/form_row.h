// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFormLayout;
class QLayout;
class QWidget;

namespace teleta::base {

/// Adds a row of several widgets to a form. QFormLayout shows the & of such a row's label as it is, because
/// nothing gets the keyboard by it; here that is buddy. Thread: GUI.
void addFormRow(QFormLayout& form, const QString& text, QLayout* fields, QWidget* buddy);

} // namespace teleta::base
