// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"
#include "backend/contour/robust_fit.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace teleta::contour {

/// How well a fitted model explains the points of a contour.
struct Evidence {
    double logEvidence = 0.0;
    double deviation = 0.0;     ///< most probable noise, in units of the size
    std::vector<bool> outliers; ///< one a point: more probably an outlier than noise
    [[nodiscard]] std::size_t outlierCount() const;
};

/// Logarithm of the evidence of what cannot be.
inline constexpr double kImpossibleEvidence = -std::numeric_limits<double>::infinity();

/// What is assumed of a model beside its fit.
struct Assumptions {
    /// Correlation of the deviations of neighbouring points, 0 <= c < 1. With c > 0 the model is a curve that
    /// follows the fitted one only roughly: r_i - c r_{i-1} takes the place of r_i, and s / sqrt(1 - c^2)
    /// that of s for the first point. The points must then be in the order of exploration.
    double correlation = 0.0;
    /// How far a parameter that no point determines can go before some point does, in units of the size.
    double freedom = 1.0;
};

/// Logarithm of the marginal likelihood of the points under a model of a curve of the given length, in units
/// of the size, by Laplace's method in the parameters and a sum over the noise:
///   p(points | M) = mean over s of  prod_i [ (1-e)/L N(r_i; s) + e/A ]  prod_j min(w, s sqrt(2 pi / l_j))
/// r_i: distance of point i from the curve; L: its length (points are spread evenly along it); e = 0.02, A =
/// 2: share and area of outliers; l_j: eigenvalues of J^T W J, W the probability of being no outlier; w:
/// Assumptions::freedom; s: 0.5 % .. 8 % of the size, even in log s; parameters have a prior width of the
/// size. The last product is the price of a parameter, and what makes this an information criterion that also
/// holds for few points and little noise (BIC is its limit). Thread: any (pure).
[[nodiscard]] Evidence evidence(const RobustFit& fit, double length, const Assumptions& assumptions = {});

/// Root mean square of the residuals that are no outliers; 0 when all are.
[[nodiscard]] double rmsOfInliers(const RobustFit& fit, const Evidence& evidence);

/// Evidence of points that lie nowhere in particular.
[[nodiscard]] double logEvidenceOfScatter(std::size_t points);

/// Evidence of a random walk with isotropic normal steps, on the scale of the evidence of a fitted curve,
/// which it is compared with by the order of the points: along the curve an explorer advances steadily (nine
/// in ten steps are normal about their median, the others anything), off it his deviations are noise. Both
/// models explain the means of about 14 groups of successive points, since noise hides the order of points
/// that are closer than it. points, fit.residuals, places (positions along the curve): in the order of
/// exploration. period: length of a closed curve, 0 of an open one; length: as in evidence().
[[nodiscard]] double logEvidenceOfWalk(std::span<const Point> points, const RobustFit& fit,
                                       std::span<const double> places, double length, double period);

/// log(exp(a) + exp(b)) without overflow.
[[nodiscard]] double logSum(double a, double b);

} // namespace teleta::contour
