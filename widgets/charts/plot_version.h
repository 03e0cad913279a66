// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::charts {

/// Version of the QCustomPlot library that was compiled in: "2.1.0".
[[nodiscard]] QString plotLibraryVersion();

} // namespace teleta::charts
