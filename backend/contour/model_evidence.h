// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"
#include "backend/contour/robust_fit.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace teleta::contour {

/// How well a fitted model explains the points of a contour.
struct Evidence {
    double logEvidence = 0.0;
    double deviation = 0.0;       ///< most probable standard deviation of the noise, in units of the size
    std::vector<bool> outliers{}; ///< one entry per point; true: more probably an outlier than noise
    [[nodiscard]] std::size_t outlierCount() const;
};

/// Log evidence of an impossible model.
inline constexpr double kImpossibleEvidence = -std::numeric_limits<double>::infinity();

/// What is assumed about a model besides its fit.
struct Assumptions {
    /// How far a parameter that no point determines can move before some point does, in units of the size.
    double freedom = 1.0;
};

/// Logarithm of the marginal likelihood of the points under a model of a curve of the given length, in units
/// of the size, by Laplace's method in the parameters and a sum over the noise:
///   p(points | M) = mean over s of  prod_i [ (1-e)/L N(r_i; s) + e/A ]  prod_j min(w, s sqrt(2 pi / l_j))
/// r_i: distance of point i from the curve; L: its length (points are spread evenly along it); e = 0.02, A =
/// 2: share and area of outliers; l_j: eigenvalues of J^T W J, with W the probability of not being an
/// outlier; w: Assumptions::freedom; s: 0.5 % .. 8 % of the size, uniform in log s; the prior of a parameter
/// is as wide as the size. The last product is the penalty per parameter; with it this is an information
/// criterion that also holds for few points and little noise (BIC is its limit). A model may have more
/// parameters than there are points: those that no point determines cost nothing. Thread: any (pure).
[[nodiscard]] Evidence evidence(const RobustFit& fit, double length, const Assumptions& assumptions = {});

/// The part of evidence() that needs no Jacobian: deviation and outliers; logEvidence is that of an
/// impossible model.
[[nodiscard]] Evidence judge(const Eigen::VectorXd& residuals, double length);

/// What evidence() of a chain of edges is hardly ever larger than, before it is fitted: the likelihood of
/// points at their least distances, and half of the parameters as free as a point along its edge.
/// sumOfSquares: the least that its lines can reach; length: about that of the part that was touched. Thread:
/// any (pure).
[[nodiscard]] double evidenceToExpect(std::size_t points, std::size_t parameters, double sumOfSquares,
                                      double length);

/// The fit with the largest evidence of those from the three starts (at least one) with the smallest losses.
/// length: of the curve with these parameters. Thread: any (pure).
[[nodiscard]] RobustFit fitBest(const RobustModel& model, const std::vector<RobustModel::Parameters>& starts,
                                const std::function<double(const Eigen::VectorXd& parameters)>& length);

/// Root mean square of the residuals of the inliers; 0 when all points are outliers.
[[nodiscard]] double rmsOfInliers(const RobustFit& fit, const Evidence& evidence);

/// Log evidence of points scattered evenly over an ellipse, that with their moments; on the scale of
/// evidence(). points: in units of their size, at least one.
[[nodiscard]] double logEvidenceOfScatter(std::span<const Point> points);

/// What the order of touch adds to evidence(): log likelihood ratio of an explorer who advances steadily
/// (nine in ten steps are normal about their median, the others arbitrary) against one who touches the curve
/// at arbitrary places. The spread of the steps has the best of several values, from 2 % of the size to the
/// length; at least 0. places: along the curve, in the order of touch; length: of the part that was touched;
/// period: of a closed curve, 0 of an open one. 0 for fewer than three places.
[[nodiscard]] double logEvidenceOfOrder(std::span<const double> places, double length, double period);

/// Log evidence of a curve that follows the fitted one only roughly, on the scale of evidence(). Its distance
/// from the fitted one is an Ornstein-Uhlenbeck process along the curve: normal with standard deviation a,
/// correlated by exp(-d / (h L)) over the way d. Mean over a of 3, 7 and 15 % of the size, h of 0.08 and
/// 0.25, and noise of 0.3, 1 and 3 %; by Kalman's filter. places, period: as in logEvidenceOfOrder().
[[nodiscard]] double logEvidenceOfDeparture(const RobustFit& fit, std::span<const double> places,
                                            double length, double period);

/// Log evidence of a random walk with isotropic normal steps, on the scale of evidence() of a fitted curve
/// without what its order of touch adds. Along a curve an explorer advances steadily (see
/// logEvidenceOfOrder()), and the deviations from it are noise. Both models explain the means of about 14
/// groups of successive points, because noise hides the order of points that are closer together than it.
/// points, fit.residuals, places, period, length: as in logEvidenceOfOrder().
[[nodiscard]] double logEvidenceOfWalk(std::span<const Point> points, const RobustFit& fit,
                                       std::span<const double> places, double length, double period);

/// log(exp(a) + exp(b)) without overflow.
[[nodiscard]] double logSum(double a, double b);

} // namespace teleta::contour
