// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/likelihood_search.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::study {

namespace {

using Parameter = SearchPoint::Parameter;

constexpr double kLeastSlope = 0.3;
constexpr double kMostSlope = 60.0;
/// Shares below this count as this: their logarithm is finite, and no data are likely there.
constexpr double kLeastShare = 1e-100;
constexpr double kSearchPrecision = 1e-11; ///< in the log likelihood
constexpr double kLeastDamping = 1e-6;     ///< in units of information over the range of a parameter
constexpr double kMostDamping = 1e12;

double logLikelihoodOf(double count, double share) {
    return count == 0.0 ? 0.0 : count * std::log(share);
}

double binomialLikelihood(const LevelCount& count, double share) {
    const auto k = static_cast<double>(count.correct);
    const auto n = static_cast<double>(count.trials);
    return logLikelihoodOf(k, share) + logLikelihoodOf(n - k, 1.0 - share);
}

using Rise = LikelihoodRise;

Rise gaussRise(double z, double spread) {
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    return {0.5 * std::erfc(-z / std::numbers::sqrt2), 0.5 * std::erfc(z / std::numbers::sqrt2),
            -density / spread, -z * density};
}

Rise logisticRise(double z, double spread) {
    const double small = std::exp(-std::abs(z));
    const double less = small / (1.0 + small);
    const double more = 1.0 / (1.0 + small);
    const double density = less * more;
    return {z < 0.0 ? less : more, z < 0.0 ? more : less, -density / spread, -z * density};
}

/// logRatio: log(level / threshold).
Rise weibullRise(double logRatio, double slope) {
    const double exponent = slope * logRatio;
    const double u = std::exp(std::min(exponent, 700.0));
    const double complement = std::exp(-std::min(std::numbers::ln2 * u, 700.0));
    const double density = std::numbers::ln2 * u * complement; // dF/d(exponent)
    return {-std::expm1(-std::numbers::ln2 * u), complement, -slope * density, exponent * density};
}

} // namespace

LikelihoodSearch::LikelihoodSearch(std::span<const LevelCount> counts, const FitModel& model)
    : m_counts(counts.begin(), counts.end())
    , m_model(model)
    , m_logThreshold(usesLogarithm(model)) {
    const double highest = m_counts.back().level;
    double lowest = m_counts.front().level;
    double leastPositive = highest;
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_counts.size(); ++i) {
        const double level = m_counts[i].level;
        m_logLevels.push_back(level > 0.0 ? std::log(level) : 0.0);
        if (level > 0.0)
            leastPositive = std::min(leastPositive, level);
        if (i > 0)
            gap = std::min(gap, level - m_counts[i - 1].level);
    }
    const double range = m_counts.size() > 1 ? highest - lowest : std::max(std::abs(highest), 1e-300);
    if (m_counts.size() < 2)
        gap = range;
    double least = lowest - range;
    double most = highest + range;
    if (model.scale == LevelScale::log10) {
        least = leastPositive / 10.0;
        most = highest * 10.0;
    } else if (m_logThreshold) {
        least = std::max(least, leastPositive / 10.0);
    }
    if (m_logThreshold)
        lowest = std::max(lowest, leastPositive);
    const bool weibull = model.shape == RiseShape::weibull;
    m_low = {parameterOf(least), std::log(weibull ? kLeastSlope : gap / 20.0), model.lapseLow};
    m_high = {parameterOf(most), std::log(weibull ? kMostSlope : 10.0 * range), model.lapseHigh};
    m_innerLow = parameterOf(lowest);
    m_innerHigh = parameterOf(highest);
    m_grid = std::make_shared<const Grid>(gridWith(std::nullopt, 0.0));
}

LikelihoodSearch LikelihoodSearch::withAnswers(std::span<const LevelCount> counts) const {
    LikelihoodSearch other(*this);
    other.m_counts.assign(counts.begin(), counts.end());
    return other;
}

double LikelihoodSearch::thresholdOf(double parameter) const {
    return m_logThreshold ? std::exp(parameter) : parameter;
}

double LikelihoodSearch::parameterOf(double threshold) const {
    return m_logThreshold ? std::log(threshold) : threshold;
}

PsychometricFunction LikelihoodSearch::functionOf(const FitModel& model, const std::array<double, 3>& at) {
    const double threshold = at[Parameter::threshold];
    const double lapse = at[Parameter::lapse];
    return {model.shape, usesLogarithm(model) ? std::exp(threshold) : threshold,
            std::exp(at[Parameter::spread]), model.guess.value_or(lapse), lapse};
}

PsychometricFunction LikelihoodSearch::functionAt(const SearchPoint& point) const {
    return functionOf(m_model, point.at);
}

LikelihoodRise LikelihoodSearch::riseAt(std::size_t index, const std::array<double, 3>& at) const {
    const double level = m_counts[index].level;
    const double spread = std::exp(at[Parameter::spread]);
    if (m_model.shape == RiseShape::weibull)
        return level > 0.0 ? weibullRise(m_logLevels[index] - at[Parameter::threshold], spread) : Rise{};
    const double threshold = thresholdOf(at[Parameter::threshold]);
    // So far away that F is 0 or 1; an infinite z would make the derivatives undefined.
    constexpr double kFar = 1e100;
    const double z = std::clamp((level - threshold) / spread, -kFar, kFar);
    Rise rise = m_model.shape == RiseShape::gauss ? gaussRise(z, spread) : logisticRise(z, spread);
    if (m_logThreshold)
        rise.byThreshold *= threshold;
    return rise;
}

double LikelihoodSearch::logLikelihood(const std::array<double, 3>& at, Slopes* slopes) const {
    const double lapse = at[Parameter::lapse];
    const double guess = m_model.guess.value_or(lapse);
    const double rising = 1.0 - guess - lapse;
    double sum = 0.0;
    for (std::size_t i = 0; i < m_counts.size(); ++i) {
        const Rise rise = riseAt(i, at);
        const double right = std::max(guess + rising * rise.value, kLeastShare);
        const double wrong = std::max(lapse + rising * rise.complement, kLeastShare);
        const auto k = static_cast<double>(m_counts[i].correct);
        const auto n = static_cast<double>(m_counts[i].trials);
        sum += logLikelihoodOf(k, right) + logLikelihoodOf(n - k, wrong);
        if (slopes != nullptr) {
            const Eigen::Vector3d change(rising * rise.byThreshold, rising * rise.bySpread,
                                         m_model.guess ? -rise.value : rise.complement - rise.value);
            slopes->gradient += (k / right - (n - k) / wrong) * change;
            slopes->information += n * (change / right) * (change / wrong).transpose();
        }
    }
    return sum;
}

SearchPoint LikelihoodSearch::climb(SearchPoint from, std::optional<Parameter> held) const {
    double damping = kLeastDamping;
    int small = 0;
    Slopes slopes;
    from.logLikelihood = logLikelihood(from.at, &slopes);
    for (int step = 0; step < 200 && small < 2 && damping < kMostDamping; ++step) {
        // Parameters at a limit that the likelihood pushes against stay there.
        std::array<Eigen::Index, 3> free{};
        Eigen::Index count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double push = slopes.gradient[static_cast<Eigen::Index>(i)];
            const bool pushed =
                (from.at[i] <= m_low[i] && push <= 0.0) || (from.at[i] >= m_high[i] && push >= 0.0);
            if (!pushed && held != static_cast<Parameter>(i))
                free[static_cast<std::size_t>(count++)] = static_cast<Eigen::Index>(i);
        }
        if (count == 0)
            break;
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> matrix(count, count);
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> gradient(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            gradient[i] = slopes.gradient[free[static_cast<std::size_t>(i)]];
            for (Eigen::Index j = 0; j < count; ++j)
                matrix(i, j) =
                    slopes.information(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
            // Damping shortens first the steps of parameters of which the data tell next to nothing.
            const auto p = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
            const double range = m_high[p] - m_low[p];
            matrix(i, i) = matrix(i, i) * (1.0 + 0.01 * damping) + damping / (range * range);
        }
        const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> move = matrix.llt().solve(gradient);
        SearchPoint to = from;
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto p = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
            to.at[p] = std::clamp(from.at[p] + move[i], m_low[p], m_high[p]);
        }
        Slopes there;
        to.logLikelihood = logLikelihood(to.at, &there);
        if (!(to.logLikelihood >= from.logLikelihood)) {
            damping *= 10.0;
            continue;
        }
        small = to.logLikelihood - from.logLikelihood < kSearchPrecision ? small + 1 : 0;
        damping = std::max(damping / 10.0, kLeastDamping);
        from = to;
        slopes = there;
    }
    return from;
}

LikelihoodSearch::Grid LikelihoodSearch::gridWith(std::optional<Parameter> held, double value) const {
    // Most thresholds of the grid lie among the levels, three beyond either end.
    std::vector<double> thresholds;
    for (int i = 0; i < 14; ++i)
        thresholds.push_back(std::lerp(m_innerLow, m_innerHigh, i / 13.0));
    for (int i = 1; i <= 3; ++i) {
        thresholds.push_back(std::lerp(m_innerLow, m_low[Parameter::threshold], i / 3.0));
        thresholds.push_back(std::lerp(m_innerHigh, m_high[Parameter::threshold], i / 3.0));
    }
    std::vector<double> spreads;
    for (int i = 0; i < 10; ++i)
        spreads.push_back(std::lerp(m_low[Parameter::spread], m_high[Parameter::spread], (i + 0.5) / 10.0));
    std::vector<double> lapses{m_low[Parameter::lapse]};
    if (m_model.lapseIsFree()) {
        lapses.clear();
        for (int i = 0; i < 4; ++i)
            lapses.push_back(std::lerp(m_low[Parameter::lapse], m_high[Parameter::lapse], (i + 0.5) / 4.0));
    }
    if (held == Parameter::threshold)
        thresholds = {value};
    else if (held == Parameter::spread)
        spreads = {value};
    else if (held == Parameter::lapse)
        lapses = {value};
    Grid grid;
    grid.thresholds = thresholds.size();
    for (const double threshold : thresholds) {
        for (const double spread : spreads) {
            std::vector<Rise> rises;
            for (std::size_t i = 0; i < m_counts.size(); ++i)
                rises.push_back(riseAt(i, {threshold, spread, 0.0}));
            for (const double lapse : lapses) {
                grid.points.push_back({threshold, spread, lapse});
                const double guess = m_model.guess.value_or(lapse);
                for (const Rise& rise : rises) {
                    const double rising = 1.0 - guess - lapse;
                    grid.logRight.push_back(std::log(std::max(guess + rising * rise.value, kLeastShare)));
                    grid.logWrong.push_back(
                        std::log(std::max(lapse + rising * rise.complement, kLeastShare)));
                }
            }
        }
    }
    return grid;
}

std::vector<SearchPoint> LikelihoodSearch::startsOf(const Grid& grid, std::size_t most) const {
    // The best of each threshold; of these the best few.
    const std::size_t each = grid.points.size() / grid.thresholds;
    std::vector<SearchPoint> points;
    for (std::size_t first = 0; first < grid.points.size(); first += each) {
        SearchPoint best{{}, -std::numeric_limits<double>::infinity()};
        for (std::size_t p = first; p < first + each; ++p) {
            double likelihood = 0.0;
            for (std::size_t i = 0; i < m_counts.size(); ++i) {
                const std::size_t entry = p * m_counts.size() + i;
                likelihood +=
                    static_cast<double>(m_counts[i].correct) * grid.logRight[entry] +
                    static_cast<double>(m_counts[i].trials - m_counts[i].correct) * grid.logWrong[entry];
            }
            if (likelihood > best.logLikelihood)
                best = {grid.points[p], likelihood};
        }
        points.push_back(best);
    }
    std::ranges::sort(points, std::ranges::greater(), &SearchPoint::logLikelihood);
    if (points.size() > most)
        points.resize(most);
    return points;
}

SearchPoint LikelihoodSearch::bestOfGrid() const {
    return startsOf(*m_grid, 1).front();
}

SearchPoint LikelihoodSearch::best(std::size_t starts) const {
    SearchPoint best{{}, -std::numeric_limits<double>::infinity()};
    for (const SearchPoint& start : startsOf(*m_grid, starts)) {
        const SearchPoint end = climb(start, std::nullopt);
        if (end.logLikelihood > best.logLikelihood)
            best = end;
    }
    return best;
}

SearchPoint LikelihoodSearch::bestWith(Parameter held, double value, const SearchPoint& near) const {
    SearchPoint from = near;
    from.at[held] = value;
    SearchPoint best = climb(from, held);
    const SearchPoint other = climb(startsOf(gridWith(held, value), 1).front(), held);
    return other.logLikelihood > best.logLikelihood ? other : best;
}

std::optional<Eigen::Matrix3d> LikelihoodSearch::covarianceAt(const SearchPoint& point) const {
    Slopes slopes;
    static_cast<void>(logLikelihood(point.at, &slopes));
    std::vector<Eigen::Index> free;
    for (std::size_t i = 0; i < 3; ++i) {
        if (point.at[i] > m_low[i] && point.at[i] < m_high[i])
            free.push_back(static_cast<Eigen::Index>(i));
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd(slopes.information(free, free)));
    if (free.empty() || !lu.isInvertible())
        return std::nullopt;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance(free, free) = lu.inverse();
    return covariance.allFinite() ? std::optional(covariance) : std::nullopt;
}

std::optional<double> LikelihoodSearch::errorOf(Parameter parameter, const SearchPoint& point) const {
    const std::optional<Eigen::Matrix3d> covariance = covarianceAt(point);
    const auto i = static_cast<Eigen::Index>(parameter);
    return covariance && (*covariance)(i, i) > 0.0 ? std::optional(std::sqrt((*covariance)(i, i)))
                                                   : std::nullopt;
}

double LikelihoodSearch::constantLikelihood() const {
    double correct = 0.0;
    double trials = 0.0;
    for (const LevelCount& count : m_counts) {
        correct += static_cast<double>(count.correct);
        trials += static_cast<double>(count.trials);
    }
    double sum = 0.0;
    for (const LevelCount& count : m_counts)
        sum += binomialLikelihood(count, correct / trials);
    return sum;
}

double LikelihoodSearch::saturatedLikelihood() const {
    double sum = 0.0;
    for (const LevelCount& count : m_counts)
        sum +=
            binomialLikelihood(count, static_cast<double>(count.correct) / static_cast<double>(count.trials));
    return sum;
}

} // namespace teleta::study
