// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/bayes_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::study {

namespace {

/// So that no answer empties the posterior.
constexpr double kLeastLikelihood = 1e-12;

double entropyTerm(double mass) {
    return mass > 0.0 ? -mass * std::log(mass) : 0.0;
}

} // namespace

BayesGrid::BayesGrid(const BayesSettings& settings, const LevelRange& range)
    : m_settings(settings)
    , m_range(range) {
    const double low = onScale(range.scale, range.lowest);
    const double high = onScale(range.scale, range.highest);
    for (std::size_t i = 0; i < settings.grid; ++i) {
        const double place =
            std::lerp(low, high, static_cast<double>(i) / static_cast<double>(settings.grid - 1));
        m_places.push_back(place);
        m_levels.push_back(fromScale(range.scale, place));
    }
    m_levels.front() = range.lowest;
    m_levels.back() = range.highest;
    for (const double lapse : settings.lapse) {
        if (settings.guessIsLapse) {
            m_rates.push_back({lapse, lapse});
            continue;
        }
        for (const double guess : settings.guess)
            m_rates.push_back({guess, lapse});
    }
    for (const double level : m_levels) {
        for (const double threshold : m_levels) {
            for (const double slope : settings.slope)
                m_rise.push_back(riseOf(settings.function, level, threshold, slope));
        }
    }
    double sum = 0.0;
    for (const double place : m_places) {
        double weight = 1.0;
        if (settings.priorMean && settings.priorSd) {
            const double z = (place - *settings.priorMean) / *settings.priorSd;
            weight = std::exp(-0.5 * z * z);
        }
        m_thresholdPrior.push_back(weight);
        sum += weight;
    }
    for (double& weight : m_thresholdPrior)
        weight /= sum;
}

BayesTrack::BayesTrack(const BayesGrid& grid)
    : m_grid(&grid) {
    const std::size_t others = grid.m_settings.slope.size() * grid.m_rates.size();
    for (const double prior : grid.m_thresholdPrior)
        m_mass.insert(m_mass.end(), others, prior / static_cast<double>(others));
}

void BayesTrack::add(double level, bool correct) {
    const BayesGrid& grid = *m_grid;
    const std::size_t slopes = grid.m_settings.slope.size();
    const std::size_t cells = grid.m_levels.size() * slopes;
    const auto same = std::ranges::find_if(
        grid.m_levels, [&](double l) { return std::abs(l - level) <= 1e-9 * std::abs(l); });
    const bool onGrid = same != grid.m_levels.end();
    const auto row = static_cast<std::size_t>(same - grid.m_levels.begin());
    double sum = 0.0;
    std::size_t point = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const double rise = onGrid ? grid.m_rise[row * cells + cell]
                                   : riseOf(grid.m_settings.function, level, grid.m_levels[cell / slopes],
                                            grid.m_settings.slope[cell % slopes]);
        for (const BayesGrid::Rates& rates : grid.m_rates) {
            const double share = rates.guess + (1.0 - rates.guess - rates.lapse) * rise;
            m_mass[point] *=
                std::clamp(correct ? share : 1.0 - share, kLeastLikelihood, 1.0 - kLeastLikelihood);
            sum += m_mass[point++];
        }
    }
    for (double& mass : m_mass)
        mass /= sum;
    ++m_trials;
}

double BayesTrack::bestLevel() const {
    const BayesGrid& grid = *m_grid;
    const std::size_t cells = grid.m_levels.size() * grid.m_settings.slope.size();
    const std::size_t rates = grid.m_rates.size();
    // Summed over the rates, the mass that a right answer leaves in a cell is base + F * rising.
    std::vector<double> mass(cells);
    std::vector<double> base(cells);
    std::vector<double> rising(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        for (std::size_t r = 0; r < rates; ++r) {
            const double m = m_mass[cell * rates + r];
            mass[cell] += m;
            base[cell] += m * grid.m_rates[r].guess;
            rising[cell] += m * (1.0 - grid.m_rates[r].guess - grid.m_rates[r].lapse);
        }
    }
    double best = std::numeric_limits<double>::infinity();
    std::size_t bestRow = 0;
    for (std::size_t row = 0; row < grid.m_levels.size(); ++row) {
        const double* rise = grid.m_rise.data() + row * cells;
        double right = 0.0;
        double terms = 0.0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double yes = base[cell] + rise[cell] * rising[cell];
            right += yes;
            terms += entropyTerm(yes) + entropyTerm(mass[cell] - yes);
        }
        // sum over answers of p(answer) H(posterior given it) = sum of terms - entropy of the answer.
        const double expected = terms - entropyTerm(right) - entropyTerm(1.0 - right);
        if (expected < best - 1e-10) {
            best = expected;
            bestRow = row;
        }
    }
    return grid.m_levels[bestRow];
}

std::vector<double> BayesTrack::thresholdMass() const {
    const std::size_t count = m_grid->m_levels.size();
    const std::size_t others = m_mass.size() / count;
    std::vector<double> marginal(count);
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        marginal[i / others] += m_mass[i];
    return marginal;
}

ThresholdBelief BayesTrack::belief() const {
    const std::vector<double> marginal = thresholdMass();
    const std::vector<double>& places = m_grid->m_places;
    ThresholdBelief belief;
    for (std::size_t i = 0; i < marginal.size(); ++i)
        belief.mean += marginal[i] * places[i];
    double variance = 0.0;
    for (std::size_t i = 0; i < marginal.size(); ++i)
        variance += marginal[i] * (places[i] - belief.mean) * (places[i] - belief.mean);
    belief.sd = std::sqrt(variance);
    constexpr double kTail = 0.025;
    double below = 0.0;
    std::size_t low = 0;
    while (low + 1 < marginal.size() && below + marginal[low] <= kTail)
        below += marginal[low++];
    double above = 0.0;
    std::size_t high = marginal.size() - 1;
    while (high > low && above + marginal[high] <= kTail)
        above += marginal[high--];
    belief.low = places[low];
    belief.high = places[high];
    const std::size_t last = marginal.size() - 1;
    if (marginal[0] + marginal[1] >= 0.5)
        belief.note = TrackNote::belowRange;
    else if (marginal[last] + marginal[last - 1] >= 0.5)
        belief.note = TrackNote::aboveRange;
    return belief;
}

double BayesTrack::meanSlope() const {
    const std::size_t rates = m_grid->m_rates.size();
    const std::vector<double>& slopes = m_grid->m_settings.slope;
    double mean = 0.0;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        mean += m_mass[i] * slopes[i / rates % slopes.size()];
    return mean;
}

double BayesTrack::meanLapse() const {
    double mean = 0.0;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        mean += m_mass[i] * m_grid->m_rates[i % m_grid->m_rates.size()].lapse;
    return mean;
}

std::optional<TrackEnd> BayesTrack::end() const {
    const BayesSettings& settings = m_grid->m_settings;
    const ThresholdBelief now = belief();
    const bool precise =
        settings.sdAtMost && m_trials >= settings.leastTrials && now.sd <= *settings.sdAtMost;
    if (!precise && m_trials < settings.mostTrials)
        return std::nullopt;
    TrackEnd over{precise ? EndReason::precision : EndReason::mostTrials};
    over.estimate = fromScale(m_grid->scale(), now.mean);
    over.sd = now.sd;
    over.low = fromScale(m_grid->scale(), now.low);
    over.high = fromScale(m_grid->scale(), now.high);
    over.note = now.note;
    return over;
}

TrackStep BayesTrack::next() const {
    if (const std::optional<TrackEnd> over = end())
        return *over;
    return NextLevel{bestLevel()};
}

} // namespace teleta::study
