// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <vector>

class QApplication;
class QMenu;

namespace teleta::console {

class ConsoleSettings;

/// From now on texts are in this language ("en", "fr", "ja", "zh_CN"), and numbers as it writes them; the
/// desktop's when it is empty. Where the desktop has the same language, numbers are as the desktop has them.
/// Thread: GUI.
void useLanguage(QApplication& application, const QString& language);

/// The languages of the program, {own name, code as for useLanguage()}. Thread: any.
[[nodiscard]] std::vector<std::pair<QString, QString>> languageChoices();

/// Adds a menu to choose the language in, each by its own name; the choice is used at once, and remembered.
/// Thread: GUI.
void addLanguageMenu(QMenu& view, ConsoleSettings& settings);

} // namespace teleta::console
