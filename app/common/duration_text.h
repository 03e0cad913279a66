// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::app {

/// "12 s", "5 min 12 s", "3 h 5 min", rounded up; a dash when it is not finite. Thread: any (pure).
[[nodiscard]] QString durationText(double duration_s);

} // namespace teleta::app
