// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace teleta::contact {

/// The lowest load that stands out of the background of a frame.
///   threshold = min(split, mean + 3 sd)
/// split: Otsu's, the level between two classes with the largest variance between them (histogram of 256 bins
/// from 0 to the peak); mean, sd: of the loads below it, the background. Empty when there is nothing to
/// split: no load, or all loads in one bin (a saturated frame). Scale-free.
///   loads: finite, >= 0.
/// Source: servoing paper, section 3.2 (lowest possible threshold, found automatically); N. Otsu, IEEE Trans.
/// SMC 1979.
[[nodiscard]] std::optional<double> automaticThreshold(std::span<const float> loads);

} // namespace teleta::contact
