// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::signal {

/// A unit as people read it: "m2" is m², "degC" °C, a count has none. Thread: any (pure).
[[nodiscard]] QString unitText(const QString& unit);

/// Unit of the derivative: "N" becomes N/s, that of a count 1/s. Thread: any (pure).
[[nodiscard]] QString unitPerSecond(const QString& unit);

} // namespace teleta::signal
