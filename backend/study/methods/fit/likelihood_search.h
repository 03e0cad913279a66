// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/fit/level_counts.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace teleta::study {

/// What a psychometric function is fitted with.
struct FitModel {
    RiseShape shape = RiseShape::weibull;
    LevelScale scale = LevelScale::log10; ///< of the limits of the threshold, of means and middles
    std::optional<double> guess = 0.5;    ///< fixed, 0 .. below 1; empty: g = l (comparisons)
    double lapseLow = 0.0;                ///< equal to lapseHigh: a fixed lapse rate
    double lapseHigh = 0.06;              ///< below 0.5

    [[nodiscard]] bool lapseIsFree() const { return lapseHigh > lapseLow; }
    /// Threshold, spread, and the lapse rate if it is free.
    [[nodiscard]] std::size_t freeParameters() const { return lapseIsFree() ? 3 : 2; }
};

/// A point of the search: threshold (its logarithm on a log10 scale and for weibull), logarithm of the
/// spread, lapse rate; and its log likelihood without the binomial coefficients.
struct SearchPoint {
    enum Parameter : std::size_t { threshold, spread, lapse };
    std::array<double, 3> at{};
    double logLikelihood = 0.0;
};

/// F, 1 - F without cancellation, and the derivatives of F by threshold parameter and logarithm of the
/// spread.
struct LikelihoodRise {
    double value = 0.0;
    double complement = 1.0;
    double byThreshold = 0.0;
    double bySpread = 0.0;
};

/// Maximum of the likelihood of one data set within the limits of its parameters: threshold from a tenth of
/// the lowest level to ten times the highest (linear scale: one range beyond either end), slope b 0.3 .. 60,
/// s from a twentieth of the smallest gap between levels to ten times their range. A grid of 20 x 10 x 4
/// gives the starts; each is improved by Fisher scoring within the limits to 1e-11 in the log likelihood.
/// Constant once made; thread: any.
class LikelihoodSearch {
public:
    static constexpr std::size_t kStarts = 3;

    /// counts: rising levels; on a log10 scale and for weibull at least one is above 0.
    LikelihoodSearch(std::span<const LevelCount> counts, const FitModel& model);

    /// The same search for other answers at the same levels; the tables of the grid are shared.
    [[nodiscard]] LikelihoodSearch withAnswers(std::span<const LevelCount> counts) const;

    /// starts: how many points of the grid are improved, >= 1; with more of them a lower maximum beside the
    /// highest one is not taken for it.
    [[nodiscard]] SearchPoint best(std::size_t starts = kStarts) const;
    /// The best point of the grid, as it is.
    [[nodiscard]] SearchPoint bestOfGrid() const;
    /// The best point with one parameter held at this value; near: starts from here as well.
    [[nodiscard]] SearchPoint bestWith(SearchPoint::Parameter held, double value,
                                       const SearchPoint& near) const;

    [[nodiscard]] PsychometricFunction functionAt(const SearchPoint& point) const;
    /// The function of the parameters, by the model alone.
    [[nodiscard]] static PsychometricFunction functionOf(const FitModel& model,
                                                         const std::array<double, 3>& at);
    /// Whether a search of the model has the logarithm of the threshold.
    [[nodiscard]] static bool usesLogarithm(const FitModel& model) {
        return model.scale == LevelScale::log10 || model.shape == RiseShape::weibull;
    }
    [[nodiscard]] double thresholdOf(double parameter) const;
    /// The inverse. threshold: > 0 where the search uses its logarithm.
    [[nodiscard]] double parameterOf(double threshold) const;
    [[nodiscard]] const std::array<double, 3>& lowest() const { return m_low; }
    [[nodiscard]] const std::array<double, 3>& highest() const { return m_high; }
    /// Covariance of the estimates by the expected information at a point; parameters at a limit, and a fixed
    /// lapse rate, do not vary. Empty where the information has no inverse.
    [[nodiscard]] std::optional<Eigen::Matrix3d> covarianceAt(const SearchPoint& point) const;
    /// Standard error of a parameter by the expected information at a point; empty where it has none.
    [[nodiscard]] std::optional<double> errorOf(SearchPoint::Parameter parameter,
                                                const SearchPoint& point) const;
    /// Log likelihood of one share at all levels, and of each level's own share.
    [[nodiscard]] double constantLikelihood() const;
    [[nodiscard]] double saturatedLikelihood() const;

private:
    struct Slopes {
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    };
    [[nodiscard]] double logLikelihood(const std::array<double, 3>& at, Slopes* slopes) const;
    [[nodiscard]] SearchPoint climb(SearchPoint from, std::optional<SearchPoint::Parameter> held) const;
    /// Points of a grid, by threshold, and the logarithms of both shares there, level by level.
    struct Grid {
        std::vector<std::array<double, 3>> points;
        std::vector<double> logRight;
        std::vector<double> logWrong;
        std::size_t thresholds = 0;
    };
    [[nodiscard]] Grid gridWith(std::optional<SearchPoint::Parameter> held, double value) const;
    [[nodiscard]] std::vector<SearchPoint> startsOf(const Grid& grid, std::size_t most) const;
    [[nodiscard]] LikelihoodRise riseAt(std::size_t index, const std::array<double, 3>& at) const;

    std::vector<LevelCount> m_counts;
    std::vector<double> m_logLevels; ///< natural logarithms, where levels are above 0
    FitModel m_model;
    bool m_logThreshold = true;
    std::array<double, 3> m_low{};
    std::array<double, 3> m_high{};
    double m_innerLow = 0.0; ///< parameter of the lowest level
    double m_innerHigh = 0.0;
    std::shared_ptr<const Grid> m_grid;
};

} // namespace teleta::study
