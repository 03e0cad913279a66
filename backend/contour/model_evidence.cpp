// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/model_evidence.h"

#include "backend/core/quantile.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace teleta::contour {

namespace {

constexpr double kOutlierShare = 0.02;
constexpr double kOutlierArea = 2.0;
constexpr double kOutlierDensity = kOutlierShare / kOutlierArea;
constexpr double kSmallestNoise = 0.005;
constexpr double kLargestNoise = 0.08;
constexpr std::size_t kNoiseSteps = 13;
constexpr double kScatterLogDensity = -0.8;
constexpr double kSmallestSpread = 0.02;
constexpr double kJumpShare = 0.1; ///< near a corner noise moves a point to the other edge
constexpr std::size_t kGroups = 14;

/// From the smallest to the largest noise, uniform in the logarithm.
std::array<double, kNoiseSteps> noiseSteps(double widening) {
    std::array<double, kNoiseSteps> noise{};
    for (std::size_t step = 0; step < kNoiseSteps; ++step) {
        const double share = static_cast<double>(step) / static_cast<double>(kNoiseSteps - 1);
        noise[step] = kSmallestNoise * std::pow(kLargestNoise / widening / kSmallestNoise, share);
    }
    return noise;
}

double inlierDensity(double residual, double noise, double length) {
    const double z = residual / noise;
    return (1.0 - kOutlierShare) / length * std::exp(-0.5 * z * z) /
           (noise * std::sqrt(2.0 * std::numbers::pi));
}

/// Of the residuals alone, at the most probable noise.
double logLikelihood(const Eigen::VectorXd& residuals, double length) {
    double best = -std::numeric_limits<double>::infinity();
    for (const double noise : noiseSteps(1.0)) {
        double sum = 0.0;
        for (const double r : residuals)
            sum += std::log(inlierDensity(r, noise, std::max(length, kSmallestNoise)) + kOutlierDensity);
        best = std::max(best, sum);
    }
    return best;
}

/// Log likelihood ratio: values normal about 0 with a share of arbitrary ones, against values spread over the
/// length.
double logGain(std::span<const double> values, double length) {
    double best = 0.0;
    for (double spread = kSmallestSpread; spread < length; spread *= 1.5) {
        double gain = -std::log(static_cast<double>(values.size() + 1));
        for (const double value : values) {
            const double z = value / spread;
            gain += std::log((1.0 - kJumpShare) * length * std::exp(-0.5 * z * z) /
                                 (spread * std::sqrt(2.0 * std::numbers::pi)) +
                             kJumpShare);
        }
        best = std::max(best, gain);
    }
    return best;
}

} // namespace

std::size_t Evidence::outlierCount() const {
    return static_cast<std::size_t>(std::count(outliers.begin(), outliers.end(), true));
}

double logSum(double a, double b) {
    const double larger = std::max(a, b);
    if (larger == -std::numeric_limits<double>::infinity())
        return larger;
    return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

double logEvidenceOfScatter(std::size_t points) {
    return kScatterLogDensity * static_cast<double>(points);
}

double logEvidenceOfWalk(std::span<const Point> points, const RobustFit& fit, std::span<const double> places,
                         double length, double period) {
    const auto difference = [&](double from, double to) {
        return period > 0.0 ? std::remainder(to - from, period) : to - from;
    };
    const std::size_t n = points.size();
    const auto groups = std::max<std::size_t>(1, n / std::max<std::size_t>(1, (n + kGroups / 2) / kGroups));
    if (groups < 3 || length <= 0.0)
        return -std::numeric_limits<double>::infinity();
    std::vector<Point> groupPoints(groups, Point::Zero());
    std::vector<double> groupPlaces(groups, 0.0);
    Eigen::VectorXd groupResiduals = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(groups));
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t begin = g * n / groups;
        const std::size_t end = (g + 1) * n / groups;
        const auto count = static_cast<double>(end - begin);
        groupPlaces[g] = places[begin];
        for (std::size_t i = begin; i < end; ++i) {
            groupPoints[g] += points[i] / count;
            groupPlaces[g] += difference(places[begin], places[i]) / count;
            groupResiduals[static_cast<Eigen::Index>(g)] +=
                fit.residuals[static_cast<Eigen::Index>(i)] / count;
        }
    }

    const auto steps = static_cast<double>(groups - 1);
    double squares = 0.0;
    std::vector<double> advances;
    for (std::size_t g = 1; g < groups; ++g) {
        squares += (groupPoints[g] - groupPoints[g - 1]).squaredNorm();
        advances.push_back(difference(groupPlaces[g - 1], groupPlaces[g]));
    }
    const double variance = std::max(kSmallestNoise * kSmallestNoise, squares / (2.0 * steps));
    const double walk = -steps * (std::log(2.0 * std::numbers::pi * variance) + 1.0) - 0.5 * std::log(steps);

    const double median = core::upperMedianOf(std::vector(advances));
    for (double& advance : advances)
        advance -= median;
    const double curve = logLikelihood(groupResiduals, length) + logGain(advances, length);
    return logLikelihood(fit.residuals, length) + walk - curve;
}

double rmsOfInliers(const RobustFit& fit, const Evidence& evidence) {
    double sum = 0.0;
    double count = 0.0;
    for (Eigen::Index i = 0; i < fit.residuals.size(); ++i)
        if (!evidence.outliers[static_cast<std::size_t>(i)]) {
            sum += fit.residuals[i] * fit.residuals[i];
            count += 1.0;
        }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

Evidence evidence(const RobustFit& fit, double length, const Assumptions& assumptions) {
    const double correlation = assumptions.correlation;
    const double curve = std::max(length, kSmallestNoise);
    const double widening = 1.0 / std::sqrt(1.0 - correlation * correlation);
    const Eigen::Index count = fit.residuals.size();
    const auto density = [&](Eigen::Index i, double noise) {
        if (i == 0 || correlation == 0.0)
            return inlierDensity(fit.residuals[i], noise * widening, curve);
        // An outlier carries no information about its neighbour.
        const double before = fit.residuals[i - 1];
        const double expected = std::abs(before) > 4.0 * noise * widening ? 0.0 : correlation * before;
        return inlierDensity(fit.residuals[i] - expected, noise, curve);
    };
    const std::array<double, kNoiseSteps> noise = noiseSteps(widening);
    std::array<double, kNoiseSteps> likelihood{};
    for (std::size_t step = 0; step < kNoiseSteps; ++step) {
        for (Eigen::Index i = 0; i < count; ++i)
            likelihood[step] += std::log(density(i, noise[step]) + kOutlierDensity);
    }
    const auto best =
        static_cast<std::size_t>(std::max_element(likelihood.begin(), likelihood.end()) - likelihood.begin());

    Evidence result;
    result.deviation = noise[best];
    Eigen::VectorXd weights(count);
    result.outliers.resize(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) {
        const double inlier = density(i, noise[best]);
        weights[i] = inlier / (inlier + kOutlierDensity);
        result.outliers[static_cast<std::size_t>(i)] = weights[i] < 0.5;
    }
    const Eigen::MatrixXd information = fit.jacobian.transpose() * weights.asDiagonal() * fit.jacobian;
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(information, Eigen::EigenvaluesOnly).eigenvalues();

    result.logEvidence = -std::numeric_limits<double>::infinity();
    for (std::size_t step = 0; step < kNoiseSteps; ++step) {
        double parameters = 0.0;
        for (const double l : eigenvalues) {
            const double width =
                l > 0.0 ? noise[step] * std::sqrt(2.0 * std::numbers::pi / l) : assumptions.freedom;
            parameters += std::log(std::min(width, assumptions.freedom));
        }
        result.logEvidence = logSum(result.logEvidence, likelihood[step] + parameters);
    }
    result.logEvidence -= std::log(static_cast<double>(kNoiseSteps));
    return result;
}

} // namespace teleta::contour
