// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/model_evidence.h"

#include "backend/contour/lanes.h"
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
constexpr std::size_t kStartsFitted = 3;
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
    std::array<double, kNoiseSteps> likelihoods{};
    const auto count = static_cast<std::size_t>(residuals.size());
    for (std::size_t begin = 0; begin < count; begin += kMostFactors) {
        std::array<double, kMostFactors> block; // of residuals, filled up
        const std::size_t used = std::min<std::size_t>(kMostFactors, count - begin);
        std::copy_n(residuals.data() + begin, used, block.begin());
        std::fill(block.begin() + used, block.end(), 0.0);
        std::array<double, kNoiseSteps> products{};
        doInLanes([&]() __attribute__((always_inline)) {
            std::array<Lanes, kNoiseSteps> all;
            for (Lanes& one : all)
                one = 1.0 - Lanes{};
            for (std::size_t i = 0; i < used; i += kLanes) {
                Lanes square;
                load(square, block.data() + i);
                square *= square;
                const Lanes index = static_cast<double>(i) + Lanes{0.0, 1.0, 2.0, 3.0};
                const auto within = index < static_cast<double>(used);
                for (std::size_t k = 0; k < kHalving; ++k) {
                    const double wide = noise[kNoiseSteps - 1 - k];
                    Lanes share = square * (-0.5 / (wide * wide));
                    takeExponentials(share);
                    for (std::size_t down = k; down < kNoiseSteps; down += kHalving) {
                        const std::size_t step = kNoiseSteps - 1 - down;
                        const Lanes density = share * peaks[step] + kOutlierDensity;
                        all[step] *= within ? density : 1.0 - Lanes{};
                        share *= share;
                        share *= share;
                    }
                }
            }
            for (std::size_t step = 0; step < kNoiseSteps; ++step)
                products[step] = (all[step][0] * all[step][1]) * (all[step][2] * all[step][3]);
        });
        for (std::size_t step = 0; step < kNoiseSteps; ++step)
            likelihoods[step] += std::log(products[step]);
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

/// Kalman's filter of a deviation along a curve, for several priors at once.
class Filter {
public:
    Filter(const double* prior, const double* noise2) {
        load(m_prior, prior);
        load(m_noise2, noise2);
        m_variance = m_prior;
    }
    /// Multiplies a product by the density of the next residual. keep: correlation with the deviation before.
    [[gnu::always_inline]] void take(double residual, double keep, double peak, Lanes& product) {
        m_mean *= keep;
        m_variance = keep * keep * m_variance + (1.0 - keep * keep) * m_prior;
        const Lanes inverse = 1.0 / (m_variance + m_noise2);
        const Lanes off = residual - m_mean;
        Lanes height = inverse;
        takeRoots(height);
        Lanes share = -0.5 * off * off * inverse;
        takeExponentials(share);
        product *= peak * height * share + kOutlierDensity;
        const Lanes gain = m_variance * inverse;
        m_mean += gain * off;
        m_variance *= 1.0 - gain;
    }

private:
    Lanes m_prior;
    Lanes m_noise2;
    Lanes m_mean{};
    Lanes m_variance;
};

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
    // Kalman's filter for every amplitude and noise at once, in one row for each reach.
    constexpr std::size_t kPairs = kAmplitudes.size() * kDepartureNoises.size();
    constexpr std::size_t kFilled = (kPairs + kLanes - 1) / kLanes * kLanes;
    std::array<double, kFilled> prior;
    std::array<double, kFilled> noise2;
    for (std::size_t pair = 0; pair < kFilled; ++pair) {
        const double amplitude = kAmplitudes[std::min(pair, kPairs - 1) / kDepartureNoises.size()];
        const double noise = kDepartureNoises[pair % kDepartureNoises.size()];
        prior[pair] = amplitude * amplitude;
        noise2[pair] = noise * noise;
    }
    const double peak = peakDensity(1.0, curve);
    std::array<double, kReaches.size() * kFilled> likelihoods{};
    for (std::size_t reach = 0; reach < kReaches.size(); ++reach) {
        // Correlation of a deviation with the one before.
        std::vector<double> keeps(sorted.size(), 0.0);
        for (std::size_t i = 1; i < sorted.size(); ++i)
            keeps[i] = std::exp(-(sorted[i].first - sorted[i - 1].first) / (kReaches[reach] * curve));
        for (std::size_t first = 0; first < kFilled; first += kLanes) {
            Filter filter(prior.data() + first, noise2.data() + first);
            for (std::size_t begin = 0; begin < sorted.size(); begin += kMostFactors) {
                std::array<double, kLanes> products;
                const std::size_t end = std::min<std::size_t>(begin + kMostFactors, sorted.size());
                doInLanes([&]() __attribute__((always_inline)) {
                    Lanes product = 1.0 - Lanes{};
                    for (std::size_t i = begin; i < end; ++i)
                        filter.take(sorted[i].second, keeps[i], peak, product);
                    store(products.data(), product);
                });
                for (std::size_t lane = 0; lane < kLanes; ++lane)
                    likelihoods[reach * kFilled + first + lane] += std::log(products[lane]);
            }
        }
    }
    const NormalMatrix information = normalMatrix(fit.jacobian, Eigen::VectorXd::Ones(fit.jacobian.rows()));
    const LogVolume volume(information, std::hypot(kAmplitudes.back(), kDepartureNoises.back()), 1.0);
    double sum = kImpossibleEvidence;
    for (std::size_t pair = 0; pair < kPairs; ++pair) {
        const double parameters = volume.at(std::sqrt(prior[pair] + noise2[pair]));
        for (std::size_t reach = 0; reach < kReaches.size(); ++reach)
            sum = logSum(sum, likelihoods[reach * kFilled + pair] + parameters);
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

RobustFit fitBest(const RobustModel& model, const std::vector<RobustModel::Parameters>& starts,
                  const std::function<double(const Eigen::VectorXd&)>& length) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < starts.size(); ++i)
        order.emplace_back(lossOfStart(model, starts[i]), i);
    std::ranges::sort(order);
    order.resize(std::min(order.size(), kStartsFitted));
    RobustFit best;
    double most = kImpossibleEvidence;
    for (const auto& [loss, start] : order) {
        RobustFit fit = fitRoughly(model, starts[start]);
        const double found = evidence(fit, length(fit.parameters)).logEvidence;
        if (best.parameters.size() == 0 || found > most) {
            most = found;
            best = std::move(fit);
        }
    }
    return refined(model, best);
}

double evidenceToExpect(std::size_t points, std::size_t parameters, double sumOfSquares, double length) {
    const auto n = static_cast<double>(points);
    const auto p = static_cast<double>(parameters);
    const double freedom = std::log(length / n);
    // Of a direction with its share of the information: each point gives two thirds of one to its edge's
    // ends.
    const double width = 0.5 * std::log(3.0 * std::numbers::pi * p / n);
    double most = kImpossibleEvidence;
    for (const double noise : noiseSteps()) {
        const double likelihood =
            n * std::log(peakDensity(noise, length) + kOutlierDensity) - sumOfSquares / (2.0 * noise * noise);
        // Half of the directions are about as free as a point along its edge.
        const double volume = 0.5 * p * (freedom + std::min(freedom, std::log(noise) + width));
        most = std::max(most, likelihood + volume);
    }
    return most;
}

} // namespace teleta::contour
