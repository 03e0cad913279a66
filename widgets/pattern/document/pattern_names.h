// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <QString>

namespace teleta::pattern {

/// Name to show: translated for a built-in pattern, otherwise the pattern's own. Thread: any (pure).
[[nodiscard]] QString displayName(const Pattern& pattern);

} // namespace teleta::pattern
