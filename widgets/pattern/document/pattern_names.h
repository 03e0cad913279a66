// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <QString>

namespace teleta::editor {

/// The name to show: of a built-in pattern in the language of the program, else the pattern's own. Thread:
/// any (pure).
[[nodiscard]] QString displayName(const pattern::Pattern& pattern);

} // namespace teleta::editor
