// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/cost_result.h"

#include <string>

namespace teleta::cost {

/// The mean error of each rung over the median time of a call, both on logarithmic axes, as an SVG file of
/// its own. The frontier is a staircase through filled points; bars go up to the 95 % error and right to the
/// 99 % time. A rung without any error lies on the lower border, marked 0. Rungs without time or error are
/// named below the picture. title: of the ladder. Thread: any (pure).
[[nodiscard]] std::string costSvg(const LadderCost& ladder, const std::string& title);

} // namespace teleta::cost
