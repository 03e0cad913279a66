// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>

class QKeyEvent;

namespace teleta::base {

/// The desktop's keys for Redo, and Ctrl+Y, which most desktops leave out. Menus show the first. Thread: GUI.
[[nodiscard]] QList<QKeySequence> redoKeys();
[[nodiscard]] bool isRedo(const QKeyEvent& key);

} // namespace teleta::base
