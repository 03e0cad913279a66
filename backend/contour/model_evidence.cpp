// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/model_evidence.h"

#include "backend/core/quantile.h"

#include <Eigen/Cholesky>
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

/// Density of an inlier on the curve at each noise, but for its length.
double peakDensity(double noise, double length) {
    return (1.0 - kOutlierShare) / length / (noise * std::sqrt(2.0 * std::numbers::pi));
}

/// Factors between 1e-6 and 1e6 of which the product neither overflows nor underflows.
constexpr Eigen::Index kMostFactors = 48;

/// Logarithms of products of many factors, several products at once.
template <int Products>
class LogSums {
public:
    using Numbers = Eigen::Array<double, Products, 1>;
    /// factors: each between 1e-6 and 1e6.
    void add(const Numbers& factors) {
        m_products *= factors;
        if (++m_factors == kMostFactors)
            flush();
    }
    [[nodiscard]] Numbers sums() {
        flush();
        return m_sums;
    }

private:
    void flush() {
        m_sums += m_products.log();
        m_products = 1.0;
        m_factors = 0;
    }
    Numbers m_sums = Numbers::Zero();
    Numbers m_products = Numbers::Ones();
    int m_factors = 0;
};

/// Log likelihood of residuals at each noise; length: at least kSmallestNoise.
std::array<double, kNoiseSteps> logLikelihoods(const Eigen::VectorXd& residuals, double length) {
    const std::array<double, kNoiseSteps>& noise = noiseSteps();
    // Three steps further down the noise is half as large, and the exponential the fourth power.
    constexpr std::size_t kHalving = 3;
    static_assert((kNoiseSteps - 1) % kHalving == 0 && kLargestNoise == 16.0 * kSmallestNoise &&
                  kNoiseSteps == 1 + 4 * kHalving);
    std::array<double, kNoiseSteps> peaks{};
    for (std::size_t step = 0; step < kNoiseSteps; ++step)
        peaks[step] = peakDensity(noise[step], length);
    constexpr std::size_t kWide = 16; // steps from the largest noise down, filled up
    using Numbers = Eigen::Array<double, kWide, 1>;
    Numbers heights = Numbers::Zero();
    for (std::size_t step = 0; step < kNoiseSteps; ++step)
        heights[static_cast<Eigen::Index>(step)] = peaks[kNoiseSteps - 1 - step];
    std::array<double, kHalving> exponents{};
    for (std::size_t step = 0; step < kHalving; ++step) {
        const double wide = noise[kNoiseSteps - 1 - step];
        exponents[step] = -0.5 / (wide * wide);
    }
    Eigen::Array<double, Eigen::Dynamic, kHalving> shares(residuals.size(), 3);
    for (std::size_t step = 0; step < kHalving; ++step)
        shares.col(static_cast<Eigen::Index>(step)) = (residuals.array().square() * exponents[step]).exp();
    LogSums<kWide> sums;
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        Numbers density;
        std::array<double, kHalving> share{shares(i, 0), shares(i, 1), shares(i, 2)};
        for (Eigen::Index step = 0; step < static_cast<Eigen::Index>(kWide); step += kHalving)
            for (std::size_t k = 0;
                 k < kHalving && step + static_cast<Eigen::Index>(k) < static_cast<Eigen::Index>(kWide);
                 ++k) {
                density[step + static_cast<Eigen::Index>(k)] = share[k];
                share[k] *= share[k];
                share[k] *= share[k];
            }
        sums.add(density * heights + kOutlierDensity);
    }
    const Numbers found = sums.sums();
    std::array<double, kNoiseSteps> likelihoods{};
    for (std::size_t step = 0; step < kNoiseSteps; ++step)
        likelihoods[step] = found[static_cast<Eigen::Index>(kNoiseSteps - 1 - step)];
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
    const double median = core::upperMedianOf(values);
    const auto count = static_cast<double>(values.size());
    const Eigen::ArrayXd squares =
        (Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size())) - median)
            .square();
    Eigen::ArrayXd factors(squares.size());
    double best = 0.0;
    for (double spread = kSmallestSpread; spread < length; spread *= 1.5) {
        const double height = (1.0 - kJumpShare) * length / (spread * std::sqrt(2.0 * std::numbers::pi));
        const double penalty = std::log(count + 1);
        if (count * std::log(height + kJumpShare) - penalty <= best)
            break; // nor does any wider spread gain more
        factors = height * (squares * (-0.5 / (spread * spread))).exp() + kJumpShare;
        double gain = -penalty;
        for (Eigen::Index i = 0; i < factors.size(); i += kMostFactors)
            gain += std::log(factors.segment(i, std::min(kMostFactors, factors.size() - i)).prod());
        best = std::max(best, gain);
    }
    return best;
}

Eigen::VectorXd eigenvaluesOf(const NormalMatrix& information) {
    Eigen::SelfAdjointEigenSolver<NormalMatrix> solver(information.rows());
    return solver.compute(information, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Logarithm of the volume of the parameters that explain the points, for several noises.
class LogVolume {
public:
    LogVolume(const NormalMatrix& information, double largestNoise, double freedom)
        : m_freedom(std::log(freedom)) {
        const auto count = static_cast<double>(information.rows());
        constexpr double kCircle = 2.0 * std::numbers::pi;
        // When even the flattest direction is narrower than the freedom, the determinant says it all.
        const double least = kCircle * largestNoise * largestNoise / (freedom * freedom);
        const Eigen::LLT<NormalMatrix> factor(information);
        if (factor.info() == Eigen::Success) {
            const double logDeterminant = 2.0 * factor.matrixLLT().diagonal().array().log().sum();
            const double logMean = std::log(information.trace() / std::max(1.0, count - 1.0));
            if (logDeterminant - (count - 1.0) * logMean > std::log(least)) {
                m_all = count;
                m_sum = 0.5 * (count * std::log(kCircle) - logDeterminant);
                return;
            }
        }
        for (const double l : eigenvaluesOf(information))
            m_widths.push_back(l > 0.0 ? 0.5 * std::log(kCircle / l)
                                       : std::numeric_limits<double>::infinity());
    }
    /// noise: at most the largest.
    [[nodiscard]] double at(double noise) const {
        const double logNoise = std::log(noise);
        double sum = m_sum + m_all * logNoise;
        for (const double width : m_widths)
            sum += std::min(logNoise + width, m_freedom);
        return sum;
    }

private:
    double m_freedom;
    double m_all = 0.0; ///< directions of which the sum is known
    double m_sum = 0.0;
    std::vector<double> m_widths; ///< log for noise 1, of the others
};

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
    sorted.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        sorted.emplace_back(period > 0.0 ? places[i] - period * std::floor(places[i] / period) : places[i],
                            fit.residuals[static_cast<Eigen::Index>(i)]);
    std::ranges::sort(sorted);
    // Kalman's filter for every amplitude and noise at once.
    constexpr int kPairs = kAmplitudes.size() * kDepartureNoises.size();
    using Numbers = Eigen::Array<double, kPairs + kPairs % 2, 1>;
    Numbers prior = Numbers::Ones();
    Numbers noise2 = Numbers::Ones();
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
        const double amplitude = kAmplitudes[pair / kDepartureNoises.size()];
        const double noise = kDepartureNoises[pair % kDepartureNoises.size()];
        prior[static_cast<Eigen::Index>(pair)] = amplitude * amplitude;
        noise2[static_cast<Eigen::Index>(pair)] = noise * noise;
    }
    const NormalMatrix information = normalMatrix(fit.jacobian, Eigen::VectorXd::Ones(fit.jacobian.rows()));
    const LogVolume volume(information, std::hypot(kAmplitudes.back(), kDepartureNoises.back()), 1.0);
    Numbers parameters = Numbers::Zero();
    for (Eigen::Index pair = 0; pair < kPairs; ++pair)
        parameters[pair] = volume.at(std::sqrt(prior[pair] + noise2[pair]));
    const double peak = peakDensity(1.0, curve);
    double sum = -std::numeric_limits<double>::infinity();
    for (const double reach : kReaches) {
        Numbers mean = Numbers::Zero();
        Numbers variance = prior;
        LogSums<Numbers::RowsAtCompileTime> likelihood;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            // Correlation of a deviation with the one before.
            const double keep =
                i > 0 ? std::exp(-(sorted[i].first - sorted[i - 1].first) / (reach * curve)) : 0.0;
            mean *= keep;
            variance = keep * keep * variance + (1.0 - keep * keep) * prior;
            const Numbers inverse = 1.0 / (variance + noise2);
            const Numbers off = sorted[i].second - mean;
            likelihood.add(peak * inverse.sqrt() * (-0.5 * off * off * inverse).exp() + kOutlierDensity);
            const Numbers gain = variance * inverse;
            mean += gain * off;
            variance *= 1.0 - gain;
        }
        const Numbers sums = likelihood.sums() + parameters;
        for (Eigen::Index pair = 0; pair < kPairs; ++pair)
            sum = logSum(sum, sums[pair]);
    }
    return sum - std::log(static_cast<double>(kReaches.size() * kPairs));
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

namespace {

struct Judged {
    std::array<double, kNoiseSteps> likelihood; ///< log, at each noise
    Eigen::VectorXd weights;                    ///< probability of not being an outlier
    Evidence evidence;
};

Judged judged(const Eigen::VectorXd& residuals, double curve) {
    const std::array<double, kNoiseSteps>& noise = noiseSteps();
    Judged result{logLikelihoods(residuals, curve), Eigen::VectorXd(residuals.size()), {}};
    const auto best =
        static_cast<std::size_t>(std::ranges::max_element(result.likelihood) - result.likelihood.begin());
    result.evidence.logEvidence = kImpossibleEvidence;
    result.evidence.deviation = noise[best];
    result.weights = peakDensity(noise[best], curve) *
                     (residuals.array().square() * (-0.5 / (noise[best] * noise[best]))).exp();
    result.weights = result.weights.array() / (result.weights.array() + kOutlierDensity);
    result.evidence.outliers.resize(static_cast<std::size_t>(residuals.size()));
    for (Eigen::Index i = 0; i < residuals.size(); ++i)
        result.evidence.outliers[static_cast<std::size_t>(i)] = result.weights[i] < 0.5;
    return result;
}

} // namespace

Evidence judge(const Eigen::VectorXd& residuals, double length) {
    return judged(residuals, std::max(length, kSmallestNoise)).evidence;
}

Evidence evidence(const RobustFit& fit, double length, const Assumptions& assumptions) {
    Judged found = judged(fit.residuals, std::max(length, kSmallestNoise));
    const std::array<double, kNoiseSteps>& noise = noiseSteps();
    const LogVolume volume(normalMatrix(fit.jacobian, found.weights), kLargestNoise, assumptions.freedom);
    double& sum = found.evidence.logEvidence;
    for (std::size_t step = 0; step < kNoiseSteps; ++step)
        sum = logSum(sum, found.likelihood[step] + volume.at(noise[step]));
    sum -= std::log(static_cast<double>(kNoiseSteps));
    return std::move(found.evidence);
}

} // namespace teleta::contour
