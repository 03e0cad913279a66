// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLineEdit;
class QWidget;

namespace teleta::base {

/// Ctrl+F leads to a search field while the page that has it is in view. Its placeholder text should name the
/// key. Thread: GUI.
void findBy(QLineEdit* search, QWidget* page);

} // namespace teleta::base
