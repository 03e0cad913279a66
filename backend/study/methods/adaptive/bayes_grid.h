// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/track.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::study {

/// The marginal distribution of the threshold after some trials.
struct ThresholdBelief {
    double mean = 0.0; ///< on the scale
    double sd = 0.0;   ///< on the scale
    double low =
        0.0; ///< 95 % interval on the scale: whole steps of the grid that leave out at most 2.5 % at each end
    double high = 0.0;
    TrackNote note = TrackNote::none; ///< belowRange, aboveRange
};

/// The tables of a Bayesian procedure: F of every level, threshold and slope. Constant once made; one for all
/// tracks of the same settings, shared between threads.
class BayesGrid {
public:
    /// settings, range: without a settingsFault().
    BayesGrid(const BayesSettings& settings, const LevelRange& range);

    [[nodiscard]] const BayesSettings& settings() const { return m_settings; }
    [[nodiscard]] LevelScale scale() const { return m_range.scale; }
    /// Levels and thresholds, rising, in the unit of the level.
    [[nodiscard]] const std::vector<double>& levels() const { return m_levels; }

private:
    friend class BayesTrack;

    /// g and l of a point of the grid.
    struct Rates {
        double guess = 0.0;
        double lapse = 0.0;
    };

    BayesSettings m_settings;
    LevelRange m_range;
    std::vector<double> m_places; ///< of the levels, on the scale
    std::vector<double> m_levels;
    std::vector<Rates> m_rates;           ///< every pair of a guess and a lapse rate
    std::vector<double> m_rise;           ///< F by level, then threshold, then slope
    std::vector<double> m_thresholdPrior; ///< sums to 1
};

/// The posterior of one track over (threshold, slope, rates). Thread: one; the grid must live longer.
class BayesTrack {
public:
    explicit BayesTrack(const BayesGrid& grid);

    /// Takes the answer of a trial that counts; the level may be off the grid.
    void add(double level, bool correct);

    /// The level with the smallest expected entropy of the posterior of threshold and slope, summed over the
    /// rates; equal within 1e-10: the lowest. In the unit of the level. Sources: Watson 2017,
    /// doi:10.1167/17.3.10; Prins 2013, doi:10.1167/13.7.3.
    [[nodiscard]] double bestLevel() const;

    [[nodiscard]] ThresholdBelief belief() const;
    /// Posterior means of slope and lapse rate.
    [[nodiscard]] double meanSlope() const;
    [[nodiscard]] double meanLapse() const;
    /// Posterior of each threshold of the grid; sums to 1.
    [[nodiscard]] std::vector<double> thresholdMass() const;
    [[nodiscard]] std::size_t trials() const { return m_trials; }
    /// The end, if the settings ask for it now.
    [[nodiscard]] std::optional<TrackEnd> end() const;
    /// The end or the next level.
    [[nodiscard]] TrackStep next() const;

private:
    const BayesGrid* m_grid;
    std::vector<double> m_mass; ///< by threshold, then slope, then rates
    std::size_t m_trials = 0;
};

} // namespace teleta::study
