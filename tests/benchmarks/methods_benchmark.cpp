// SPDX-License-Identifier: GPL-3.0-or-later
// The next level of a Bayesian procedure, against the same entropy summed over the whole grid, and a fit
// refitted to resamples with the tables of its grid, against a search that makes them anew. Both sides by
// turns.
#include "backend/core/random_stream.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/fit/likelihood_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <vector>

namespace {

using namespace teleta::study;

double seconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double medianOf(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

/// QUEST+ as it is usually written: the posterior of every grid point for every level and answer.
class WholeGrid {
public:
    WholeGrid(const BayesSettings& settings, const std::vector<double>& levels)
        : m_levels(levels)
        , m_slopes(settings.slope.size())
        , m_lapses(settings.lapse.size()) {
        for (const double threshold : levels) {
            for (const double slope : settings.slope) {
                for (const double lapse : settings.lapse) {
                    for (const double level : levels)
                        m_share.push_back(PsychometricFunction{settings.function, threshold, slope,
                                                               settings.guess.front(), lapse}
                                              .shareAt(level));
                }
            }
        }
        m_mass.assign(levels.size() * m_slopes * m_lapses,
                      1.0 / static_cast<double>(levels.size() * m_slopes * m_lapses));
    }

    void add(std::size_t level, bool right) {
        double sum = 0.0;
        for (std::size_t i = 0; i < m_mass.size(); ++i) {
            const double share = std::clamp(m_share[i * m_levels.size() + level], 1e-12, 1.0 - 1e-12);
            m_mass[i] *= right ? share : 1.0 - share;
            sum += m_mass[i];
        }
        for (double& mass : m_mass)
            mass /= sum;
    }

    [[nodiscard]] std::size_t best() const {
        double least = std::numeric_limits<double>::infinity();
        std::size_t found = 0;
        std::vector<double> joint(m_mass.size() / m_lapses);
        for (std::size_t level = 0; level < m_levels.size(); ++level) {
            double expected = 0.0;
            for (const bool right : {false, true}) {
                std::ranges::fill(joint, 0.0);
                double sum = 0.0;
                for (std::size_t i = 0; i < m_mass.size(); ++i) {
                    const double share = m_share[i * m_levels.size() + level];
                    const double mass = m_mass[i] * (right ? share : 1.0 - share);
                    joint[i / m_lapses] += mass;
                    sum += mass;
                }
                for (const double mass : joint) {
                    if (mass > 0.0)
                        expected -= mass * std::log(mass / sum);
                }
            }
            if (expected < least - 1e-10) {
                least = expected;
                found = level;
            }
        }
        return found;
    }

private:
    std::vector<double> m_levels;
    std::size_t m_slopes;
    std::size_t m_lapses;
    std::vector<double> m_share; ///< by point, then level
    std::vector<double> m_mass;
};

void compareNextLevels(const char* name, const BayesSettings& settings) {
    const LevelRange range;
    const BayesGrid grid(settings, range);
    std::vector<double> ours;
    std::vector<double> theirs;
    std::size_t different = 0;
    teleta::core::RandomStream random(1);
    for (int observer = 0; observer < 5; ++observer) {
        const PsychometricFunction truth{RiseShape::weibull, std::pow(10.0, -1.6 + 1.2 * random.uniform()),
                                         3.5, settings.guess.front(), 0.02};
        BayesTrack track(grid);
        WholeGrid whole(settings, grid.levels());
        for (int trial = 0; trial < 40; ++trial) {
            double level = 0.0;
            std::size_t same = 0;
            ours.push_back(seconds([&] { level = track.bestLevel(); }));
            theirs.push_back(seconds([&] { same = whole.best(); }));
            different += level == grid.levels()[same] ? 0 : 1;
            const bool right = random.uniform() < truth.shareAt(level);
            track.add(level, right);
            whole.add(
                static_cast<std::size_t>(std::ranges::find(grid.levels(), level) - grid.levels().begin()),
                right);
        }
    }
    std::printf("%s: next level %.3f ms (longest %.3f ms), whole grid %.3f ms, ratio %.1f; %zu of %zu levels "
                "differ\n",
                name, 1e3 * medianOf(ours), 1e3 * *std::ranges::max_element(ours), 1e3 * medianOf(theirs),
                medianOf(theirs) / medianOf(ours), different, ours.size());
}

void compareResamples() {
    const std::vector<LevelCount> data{{.02, 22, 40}, {.04, 25, 40}, {.06, 29, 40},
                                       {.08, 33, 40}, {.12, 38, 40}, {.16, 39, 40}};
    const LikelihoodSearch tables(data, FitModel{});
    const PsychometricFunction truth = tables.functionAt(tables.best());
    teleta::core::RandomStream random(1);
    std::vector<double> ours;
    std::vector<double> theirs;
    double largest = 0.0;
    for (int b = 0; b < 1000; ++b) {
        std::vector<LevelCount> drawn = data;
        for (LevelCount& count : drawn) {
            count.correct = 0;
            for (std::int64_t i = 0; i < count.trials; ++i)
                count.correct += random.uniform() < truth.shareAt(count.level) ? 1 : 0;
        }
        SearchPoint one;
        SearchPoint other;
        ours.push_back(seconds([&] { one = tables.withAnswers(drawn).best(); }));
        theirs.push_back(seconds([&] { other = LikelihoodSearch(drawn, FitModel{}).best(); }));
        largest = std::max(largest, std::abs(one.logLikelihood - other.logLikelihood));
    }
    std::printf(
        "refit of 6 x 40 trials: %.1f us, with tables made anew %.1f us, ratio %.1f; log likelihoods within "
        "%.1e\n",
        1e6 * medianOf(ours), 1e6 * medianOf(theirs), medianOf(theirs) / medianOf(ours), largest);
}

} // namespace

int main() {
    compareNextLevels("2 intervals, 41 x 8 x 4", BayesSettings{});
    BayesSettings fine;
    fine.grid = 81;
    compareNextLevels("2 intervals, 81 x 8 x 4", fine);
    compareResamples();
    return 0;
}
