// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFormLayout;
class QLayout;
class QWidget;

namespace teleta::base {

/// Adds a row of several widgets to a form, with a buddy for its label: without one QFormLayout shows the
/// label's & literally. Thread: GUI.
void addFormRow(QFormLayout& form, const QString& text, QLayout* fields, QWidget* buddy);

} // namespace teleta::base
