// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/repeated_anova.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <span>

namespace teleta::study {

/// Values count as equal, and differences as 0, within this part of the largest value: shares of counts are
/// not exact as doubles.
inline constexpr double kTieTolerance = 1e-12;

/// Wilcoxon's signed rank test.
struct SignedRankTest {
    std::size_t participants = 0; ///< with both values
    std::size_t zeros = 0;        ///< differences of 0
    double positive = 0.0;        ///< W+, sum of the ranks of positive differences
    double negative = 0.0;        ///< W-
    double p = 1.0;               ///< two-sided
    bool isExact = false;
    double rankBiserial = 0.0; ///< (W+ - W-) / (W+ + W-)
};

/// Differences that are not 0 up to this many: exact distribution; above: normal, with the variance of ties.
inline constexpr std::size_t kMostExactRanks = 25;

/// Signed rank test of first - second. Zeros are ranked and then left out (Pratt); equal sizes share their
/// mean rank. p is exact, from the distribution over all signs by dynamic programming on doubled ranks, or
/// normal without a correction for continuity. Rows with a missing value (NaN) are left out. Refusal: noData,
/// notFinite, noVariance (all differences are 0). Thread: any. Source: Wilcoxon 1945, doi:10.2307/3001968;
/// Pratt 1959, doi:10.1080/01621459.1959.10501526; Kerby 2014, doi:10.2466/11.IT.3.1.
[[nodiscard]] tl::expected<SignedRankTest, Refusal> signedRankTest(std::span<const double> first,
                                                                   std::span<const double> second);

/// Friedman's test.
struct FriedmanTest {
    std::size_t participants = 0; ///< with all values
    double chi2 = 0.0;
    double df = 0.0;
    double p = 1.0;
    double w = 0.0; ///< Kendall's coefficient of concordance, chi2 / (n (k - 1))
};

/// Ranks within participants (rows), mean ranks for ties; with column sums R_j of ranks r_ij
///   chi2 = (k-1) sum_j (R_j - n(k+1)/2)^2 / (sum_ij r_ij^2 - n k (k+1)^2 / 4),  df = k - 1.
/// Rows with a missing value are left out. Refusal: noData, badShape, tooFewLevels, notFinite,
/// oneParticipant, noVariance (every row is all ties). Thread: any. Source: Friedman 1937,
/// doi:10.1080/01621459.1937.10503522.
[[nodiscard]] tl::expected<FriedmanTest, Refusal> friedmanTest(const ParticipantCells& cells);

} // namespace teleta::study
