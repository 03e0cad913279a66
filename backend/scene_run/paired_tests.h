// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace teleta::scene_run {

/// Probability of a mean difference as far from 0 as this, or farther, if the sign of each difference were
/// chance: exact permutation test over all 2^n signs, for more than 16 differences over 20 000 drawn ones
/// with a fixed seed. The smallest possible value is 2 / 2^n, so fewer than 6 differences never have p <
/// 0.05. All 0: 1. NaN for fewer than two, or one that is not finite. Thread: any. Source: Fisher 1935, The
/// Design of Experiments, section 21.
[[nodiscard]] double pairedMeanTest(std::span<const double> differences);

/// The same test of | |a_i - median a| - |b_i - median b| |: whether values spread differently in two
/// conditions with the same seeds. a, b: of the same size, else NaN. Source of the deviations: Brown and
/// Forsythe 1974, doi:10.1080/01621459.1974.10482955. Deviations from an estimated centre make it nearly, not
/// quite exact: in normal cases of 8 pairs p < 0.05 in 3.5 to 4.3 %.
[[nodiscard]] double pairedSpreadTest(std::span<const double> a, std::span<const double> b);

} // namespace teleta::scene_run
