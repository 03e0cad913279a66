// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenu;

namespace teleta::console {

class ConsoleSettings;

/// Adds a menu to choose the language in, each by its own name; the choice is used at once, and remembered.
/// Thread: GUI.
void addLanguageMenu(QMenu& view, ConsoleSettings& settings);

} // namespace teleta::console
