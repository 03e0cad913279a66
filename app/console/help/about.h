// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/theme.h"

#include <QString>

class QWidget;

namespace teleta::console {

/// "light", "dark", anything else: as on the desktop.
[[nodiscard]] base::ThemeChoice themeFromName(const QString& name);

/// Opens the about dialog: version, licence, versions of the libraries in use.
void openAbout(QWidget* parent);
/// Opens the list of keyboard shortcuts.
void openShortcuts(QWidget* parent);

} // namespace teleta::console
