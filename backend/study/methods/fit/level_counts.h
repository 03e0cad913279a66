// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/track.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// Answers at one level.
struct LevelCount {
    double level = 0.0;
    std::int64_t correct = 0; ///< 0 .. trials
    std::int64_t trials = 0;
};

/// The trials that count, by level, rising; levels that differ by less than 1e-9 of their size are one.
/// Thread: any.
[[nodiscard]] std::vector<LevelCount> levelCounts(std::span<const KeptTrial> trials);

/// The test of a trend in the share of correct answers, on the ranks of the levels:
///   z = sum w (k - n p) / sqrt(p (1 - p) (sum n w^2 - (sum n w)^2 / N)),  p pooled, w rank
/// 0 where all answers or all levels are the same. Thread: any. Source: Armitage 1955, doi:10.2307/3001775.
[[nodiscard]] double trendZ(std::span<const LevelCount> counts);

/// Rate of false alarms that a fit takes as its guess rate: (k + 1/2) / (n + 1). Thread: any. Source: Hautus
/// 1995, doi:10.3758/BF03203619.
[[nodiscard]] double loglinearRate(std::int64_t count, std::int64_t trials);

} // namespace teleta::study
