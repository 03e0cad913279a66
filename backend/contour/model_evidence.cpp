// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/model_evidence.h"

#include "backend/core/quantile.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace teleta::contour {

namespace {

constexpr double kOutlierShare = 0.02;
constexpr double kOutlierArea = 2.0;
constexpr double kOutlierDensity = kOutlierShare / kOutlierArea;
constexpr double kSmallestNoise = 0.005;
constexpr double kLargestNoise = 0.08;
constexpr std::size_t kNoiseSteps = 13;
constexpr double kSmallestDeterminant = 1e-4; ///< of the covariance of scattered points
constexpr double kSmallestSpread = 0.02;
constexpr double kJumpShare = 0.1; ///< near a corner noise moves a point to the other edge
constexpr std::size_t kGroups = 14;
// Of curves that follow a fitted one only roughly.
constexpr std::array kAmplitudes{0.03, 0.07, 0.15};
constexpr std::array kReaches{0.08, 0.25}; ///< of the length
constexpr std::array kDepartureNoises{0.003, 0.01, 0.03};

/// From the smallest to the largest noise, uniform in the logarithm.
const std::array<double, kNoiseSteps>& noiseSteps() {
    static const std::array<double, kNoiseSteps> made = [] {
        std::array<double, kNoiseSteps> noise{};
        for (std::size_t step = 0; step < kNoiseSteps; ++step) {
            const double share = static_cast<double>(step) / static_cast<double>(kNoiseSteps - 1);
            noise[step] = kSmallestNoise * std::pow(kLargestNoise / kSmallestNoise, share);
        }
        return noise;
    }();
    return made;
}

double inlierDensity(double residual, double noise, double length) {
    const double z = residual / noise;
    return (1.0 - kOutlierShare) / length * std::exp(-0.5 * z * z) /
           (noise * std::sqrt(2.0 * std::numbers::pi));
}

/// Sum of logarithms, by the logarithm of products.
class LogSum {
public:
    /// factor: between 1e-6 and 1e6.
    void add(double factor) {
        m_product *= factor;
        if (++m_factors == kMostFactors)
            flush();
    }
    [[nodiscard]] double sum() {
        flush();
        return m_sum;
    }

private:
    static constexpr int kMostFactors = 48; ///< of which the product neither overflows nor underflows
    void flush() {
        m_sum += std::log(m_product);
        m_product = 1.0;
        m_factors = 0;
    }
    double m_sum = 0.0;
    double m_product = 1.0;
    int m_factors = 0;
};

/// Log likelihood of residuals at each noise; length: at least kSmallestNoise.
std::array<double, kNoiseSteps> logLikelihoods(const Eigen::VectorXd& residuals, double length) {
    const std::array<double, kNoiseSteps>& noise = noiseSteps();
    std::array<double, kNoiseSteps> likelihoods{};
    const Eigen::ArrayXd squares = residuals.array().square();
    Eigen::ArrayXd density(residuals.size());
    for (std::size_t step = 0; step < kNoiseSteps; ++step) {
        const double height = inlierDensity(0.0, noise[step], length);
        density = height * (squares * (-0.5 / (noise[step] * noise[step]))).exp() + kOutlierDensity;
        LogSum sum;
        for (const double d : density)
            sum.add(d);
        likelihoods[step] = sum.sum();
    }
    return likelihoods;
}

/// Of the residuals alone, at the most probable noise.
double logLikelihood(const Eigen::VectorXd& residuals, double length) {
    return std::ranges::max(logLikelihoods(residuals, std::max(length, kSmallestNoise)));
}

/// Along an open curve, or the shorter way around a closed one.
double advance(double from, double to, double period) {
    return period > 0.0 ? std::remainder(to - from, period) : to - from;
}

/// Log likelihood ratio: values normal about their median with a share of arbitrary ones, against values
/// spread over the length. values: at least one.
double logGain(std::vector<double> values, double length) {
    const double median = core::upperMedianOf(std::vector(values));
    double best = 0.0;
    for (double spread = kSmallestSpread; spread < length; spread *= 1.5) {
        const double height = (1.0 - kJumpShare) * length / (spread * std::sqrt(2.0 * std::numbers::pi));
        LogSum gain;
        for (const double value : values) {
            const double z = (value - median) / spread;
            gain.add(height * std::exp(-0.5 * z * z) + kJumpShare);
        }
        best = std::max(best, gain.sum() - std::log(static_cast<double>(values.size() + 1)));
    }
    return best;
}

Eigen::VectorXd eigenvaluesOf(const NormalMatrix& information) {
    return Eigen::SelfAdjointEigenSolver<NormalMatrix>(information, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Logarithm of the volume of the parameters that explain the points, at this noise.
double logVolume(const Eigen::VectorXd& eigenvalues, double noise, double freedom) {
    double sum = 0.0;
    for (const double l : eigenvalues) {
        const double width = l > 0.0 ? noise * std::sqrt(2.0 * std::numbers::pi / l) : freedom;
        sum += std::log(std::min(width, freedom));
    }
    return sum;
}

/// Of deviations that are an Ornstein-Uhlenbeck process plus noise. sorted: places and deviations; kept: the
/// correlation of each with the one before.
double logLikelihoodOfProcess(std::span<const std::pair<double, double>> sorted, std::span<const double> kept,
                              double amplitude, double noise, double length) {
    const double prior = amplitude * amplitude;
    double mean = 0.0;
    double variance = prior;
    LogSum sum;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double keep = kept[i];
        mean *= keep;
        variance = keep * keep * variance + (1.0 - keep * keep) * prior;
        const double expected = variance + noise * noise;
        const double off = sorted[i].second - mean;
        sum.add(inlierDensity(off, std::sqrt(expected), length) + kOutlierDensity);
        const double gain = variance / expected;
        mean += gain * off;
        variance *= 1.0 - gain;
    }
    return sum.sum();
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

double logEvidenceOfScatter(std::span<const Point> points) {
    const auto n = static_cast<double>(points.size());
    Point mean = Point::Zero();
    for (const Point& p : points)
        mean += p / n;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    for (const Point& p : points)
        covariance += (p - mean) * (p - mean).transpose() / n;
    const double area =
        4.0 * std::numbers::pi * std::sqrt(std::max(kSmallestDeterminant, covariance.determinant()));
    return -n * std::log(area);
}

double logEvidenceOfOrder(std::span<const double> places, double length, double period) {
    if (places.size() < 3 || length <= 0.0)
        return 0.0;
    std::vector<double> advances;
    for (std::size_t i = 1; i < places.size(); ++i)
        advances.push_back(advance(places[i - 1], places[i], period));
    return logGain(std::move(advances), length);
}

double logEvidenceOfDeparture(const RobustFit& fit, std::span<const double> places, double length,
                              double period) {
    const double curve = std::max(length, kSmallestNoise);
    std::vector<std::pair<double, double>> sorted; // place, residual
    for (std::size_t i = 0; i < places.size(); ++i)
        sorted.emplace_back(period > 0.0 ? places[i] - period * std::floor(places[i] / period) : places[i],
                            fit.residuals[static_cast<Eigen::Index>(i)]);
    std::ranges::sort(sorted);
    const Eigen::VectorXd eigenvalues =
        eigenvaluesOf(normalMatrix(fit.jacobian, Eigen::VectorXd::Ones(fit.jacobian.rows())));
    double sum = -std::numeric_limits<double>::infinity();
    std::vector<double> kept(sorted.size(), 0.0); // correlation of a deviation with the one before
    for (const double reach : kReaches) {
        for (std::size_t i = 1; i < sorted.size(); ++i)
            kept[i] = std::exp(-(sorted[i].first - sorted[i - 1].first) / (reach * curve));
        for (const double amplitude : kAmplitudes)
            for (const double noise : kDepartureNoises) {
                const double parameters = logVolume(eigenvalues, std::hypot(noise, amplitude), 1.0);
                sum = logSum(sum, logLikelihoodOfProcess(sorted, kept, amplitude, noise, curve) + parameters);
            }
    }
    return sum -
           std::log(static_cast<double>(kReaches.size() * kAmplitudes.size() * kDepartureNoises.size()));
}

double logEvidenceOfWalk(std::span<const Point> points, const RobustFit& fit, std::span<const double> places,
                         double length, double period) {
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
            groupPlaces[g] += advance(places[begin], places[i], period) / count;
            groupResiduals[static_cast<Eigen::Index>(g)] +=
                fit.residuals[static_cast<Eigen::Index>(i)] / count;
        }
    }

    const auto steps = static_cast<double>(groups - 1);
    double squares = 0.0;
    std::vector<double> advances;
    for (std::size_t g = 1; g < groups; ++g) {
        squares += (groupPoints[g] - groupPoints[g - 1]).squaredNorm();
        advances.push_back(advance(groupPlaces[g - 1], groupPlaces[g], period));
    }
    const double variance = std::max(kSmallestNoise * kSmallestNoise, squares / (2.0 * steps));
    const double walk = -steps * (std::log(2.0 * std::numbers::pi * variance) + 1.0) - 0.5 * std::log(steps);

    const double curve = logLikelihood(groupResiduals, length) + logGain(std::move(advances), length);
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
    const double curve = std::max(length, kSmallestNoise);
    const Eigen::Index count = fit.residuals.size();
    const std::array<double, kNoiseSteps>& noise = noiseSteps();
    const std::array<double, kNoiseSteps> likelihood = logLikelihoods(fit.residuals, curve);
    const auto best =
        static_cast<std::size_t>(std::max_element(likelihood.begin(), likelihood.end()) - likelihood.begin());

    Evidence result;
    result.deviation = noise[best];
    Eigen::VectorXd weights(count);
    result.outliers.resize(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) {
        const double inlier = inlierDensity(fit.residuals[i], noise[best], curve);
        weights[i] = inlier / (inlier + kOutlierDensity);
        result.outliers[static_cast<std::size_t>(i)] = weights[i] < 0.5;
    }
    const Eigen::VectorXd eigenvalues = eigenvaluesOf(normalMatrix(fit.jacobian, weights));
    result.logEvidence = -std::numeric_limits<double>::infinity();
    for (std::size_t step = 0; step < kNoiseSteps; ++step)
        result.logEvidence = logSum(
            result.logEvidence, likelihood[step] + logVolume(eigenvalues, noise[step], assumptions.freedom));
    result.logEvidence -= std::log(static_cast<double>(kNoiseSteps));
    return result;
}

} // namespace teleta::contour
