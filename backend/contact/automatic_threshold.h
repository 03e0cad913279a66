// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace teleta::contact {

/// The lowest load that stands out from the background of a frame.
///   threshold = min(split, mean + 3 sd)
/// split is Otsu's threshold: the level that maximises the variance between the two classes of a histogram of
/// 256 bins from 0 to the peak. mean and sd are those of the background, the loads below split. Empty when
/// there is nothing to split: no load, or all loads in one bin (a saturated frame). Independent of the unit
/// of load. Thread: any (pure).
///   loads: finite, >= 0.
/// Source: servoing paper, section 3.2 (the lowest possible threshold is found automatically); N. Otsu, IEEE
/// Trans. SMC 1979.
[[nodiscard]] std::optional<double> automaticThreshold(std::span<const float> loads);

} // namespace teleta::contact
