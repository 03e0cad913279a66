// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/fit/psychometric_fit.h"

namespace teleta::study {

/// The 95 % quantile of chi-square with one degree of freedom.
inline constexpr double kChiSquare95 = 3.841458820694124;

/// All values of a parameter with 2 (Lmax - Lprofile) <= kChiSquare95, the other parameters at their best
/// within their limits; an end that is not reached within the parameter's limits is open. In the search's
/// terms. Thread: any. Source: Venzon and Moolgavkar 1988, doi:10.2307/2347496.
[[nodiscard]] OpenInterval profileInterval(const LikelihoodSearch& search, SearchPoint::Parameter parameter,
                                           const SearchPoint& best);

} // namespace teleta::study
