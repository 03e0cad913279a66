// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// Student's paired t test of two columns, and the sizes of the effect.
struct PairedTest {
    double t = 0.0;
    double df = 0.0;
    double p = 1.0;                     ///< two-sided
    Interval interval;                  ///< of the mean difference, 95 %, of this comparison alone
    double dz = 0.0;                    ///< t / sqrt(n): over the spread of the differences
    std::optional<Interval> dzInterval; ///< standardizedDifferenceInterval()
    std::optional<double> dav;          ///< difference / sqrt((s1^2 + s2^2)/2); empty without any spread
    std::optional<double> hedges;       ///< J for n - 1 degrees of freedom; empty for two participants
    /// d_z without its bias, J d_z.
    [[nodiscard]] std::optional<double> gz() const {
        return hedges ? std::optional(*hedges * dz) : std::nullopt;
    }
};

/// Two columns of the same participants. Rows with a missing value are left out.
struct PairedComparison {
    std::size_t participants = 0;     ///< with both values
    std::optional<double> difference; ///< mean of first - second; empty without participants
    /// Error: oneParticipant; noVariance: all differences are 0; noErrorVariance: all are equal, so that t
    /// would be infinite; notFinite.
    tl::expected<PairedTest, Refusal> test;
};

/// Compares first with second. Both as long as there are participants; NaN: missing. Differences that are
/// equal but for rounding count as equal. Thread: any. Source: of d_z and d_av Lakens 2013,
/// doi:10.3389/fpsyg.2013.00863.
[[nodiscard]] PairedComparison comparePaired(std::span<const double> first, std::span<const double> second);

/// Holm's adjusted p values of a family: with m values in rising order,
///   p'_(i) = max over j <= i of min(1, (m - j + 1) p_(j)).
/// Empty values stay empty and do not count as members. Thread: any. Source: Holm 1979, Scand J Stat 6:65.
[[nodiscard]] std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p);

} // namespace teleta::study
