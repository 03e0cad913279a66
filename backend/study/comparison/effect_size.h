// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"

#include <cstddef>
#include <optional>

namespace teleta::study {

/// Interval of d_z = t / sqrt(n) from the noncentral t distribution with n - 1 degrees of freedom: the
/// noncentralities with P(T <= t) = 1 - a/2 and a/2, a = 1 - confidence, over sqrt(n). n: at least 2; t:
/// finite. Empty out of these ranges and where the distribution cannot be computed (|t| in the thousands and
/// beyond). Relative error < 1e-8. Thread: any. Source: Cumming and Finch 2001, doi:10.1177/0013164401614002.
[[nodiscard]] std::optional<Interval> standardizedDifferenceInterval(double t, std::size_t n,
                                                                     double confidence = 0.95);

/// Hedges' correction J = Gamma(v/2) / (sqrt(v/2) Gamma((v-1)/2)) of a standardized difference with v degrees
/// of freedom. freedom: above 1, else empty. Thread: any. Source: Hedges 1981, doi:10.2307/1164588.
[[nodiscard]] std::optional<double> hedgesFactor(double freedom);

/// Interval of partial eta squared from the noncentral F distribution: lambda / (lambda + df1 + df2 + 1) of
/// the noncentralities lambda with P(F <= f) = 1 - a/2 and a/2; 0 where there is none. It needs sphericity.
/// f: 0 or more; df1, df2: above 0. Empty out of these ranges and where the distribution cannot be computed.
/// Relative error < 1e-8. Thread: any. Source: Steiger 2004, doi:10.1037/1082-989X.9.2.164.
[[nodiscard]] std::optional<Interval> partialEta2Interval(double f, double df1, double df2,
                                                          double confidence = 0.95);

} // namespace teleta::study
