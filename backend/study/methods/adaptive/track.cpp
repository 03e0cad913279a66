// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/track.h"

#include "backend/core/random_stream.h"
#include "backend/core/words.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/adaptive/staircase.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::study {

namespace {

constexpr core::Words<EndReason, 7> kEndReasons{
    {"allShown", "reversals", "mostTrials", "precision", "atFloor", "atCeiling", "badSettings"}};
constexpr core::Words<TrackNote, 6> kTrackNotes{
    {"", "atFloor", "atCeiling", "tooFewReversals", "belowRange", "aboveRange"}};

/// Every level of a track of constant stimuli, in the order in which they are shown.
std::vector<double> constantLevels(const ConstantSettings& settings, std::uint64_t seed) {
    std::vector<double> order;
    for (std::size_t i = 0; i < settings.repetitions; ++i)
        order.insert(order.end(), settings.levels.begin(), settings.levels.end());
    core::RandomStream random(seed);
    const std::span<double> all(order);
    const std::size_t block = settings.blocked ? settings.levels.size() : order.size();
    for (std::size_t i = 0; i < order.size(); i += block)
        random.shuffle(all.subspan(i, block));
    return order;
}

/// The procedure that shows a track step by step.
class TrackSteps {
public:
    TrackSteps(const Procedure& procedure, const LevelRange& range, std::uint64_t seed)
        : m_procedure(procedure)
        , m_range(range) {
        if (const auto* constant = std::get_if<ConstantSettings>(&procedure))
            m_constant = constantLevels(*constant, seed);
        else if (const auto* bayes = std::get_if<BayesSettings>(&procedure))
            m_grid.emplace(*bayes, range);
        if (m_grid)
            m_bayes.emplace(*m_grid);
    }

    /// Takes a trial that counts.
    void add(const KeptTrial& trial) {
        m_counted.push_back(trial);
        if (m_bayes)
            m_bayes->add(trial.level, trial.correct);
    }

    [[nodiscard]] TrackStep next() const {
        if (m_bayes)
            return m_bayes->next();
        if (const auto* staircase = std::get_if<StaircaseSettings>(&m_procedure))
            return staircaseTrack(*staircase, m_range, m_counted).next;
        if (m_counted.size() < m_constant.size())
            return NextLevel{m_constant[m_counted.size()]};
        return TrackEnd{EndReason::allShown};
    }

private:
    const Procedure& m_procedure;
    LevelRange m_range;
    std::vector<double> m_constant;
    std::optional<BayesGrid> m_grid;
    std::optional<BayesTrack> m_bayes;
    std::vector<KeptTrial> m_counted;
};

const char* rangeFault(const LevelRange& range) {
    if (!std::isfinite(range.lowest) || !std::isfinite(range.highest) || range.lowest >= range.highest)
        return "lowest: below highest";
    if (range.scale == LevelScale::log10 && range.lowest <= 0.0)
        return "lowest: above 0 on a log10 scale";
    return "";
}

const char* constantFault(const ConstantSettings& settings, const LevelRange& range) {
    if (settings.levels.empty() || settings.levels.size() > 15)
        return "values: 1 to 15 levels";
    if (std::ranges::adjacent_find(settings.levels, std::ranges::greater_equal()) != settings.levels.end())
        return "values: rising";
    if (settings.levels.front() < range.lowest || settings.levels.back() > range.highest)
        return "values: from lowest to highest";
    return "";
}

const char* staircaseFault(const StaircaseSettings& settings, const LevelRange& range) {
    if (!(settings.first >= range.lowest && settings.first <= range.highest))
        return "first: from lowest to highest";
    if (settings.down < 1 || settings.down > 8)
        return "down: 1 to 8";
    if (!(settings.stepUp > 0.0) || !std::isfinite(settings.stepUp))
        return "step_up: above 0";
    if (!(settings.stepDown > 0.0) || !std::isfinite(settings.stepDown))
        return "step_down: above 0";
    if (!(settings.fastFactor >= 1.0) || !std::isfinite(settings.fastFactor))
        return "fast_factor: 1 or more";
    if (settings.reversals < settings.skipReversals + 2)
        return "reversals: at least skip_reversals + 2";
    if (settings.mostTrials < 1)
        return "most_trials: 1 or more";
    return "";
}

bool allWithin(const std::vector<double>& values, double least, double most) {
    return !values.empty() && std::ranges::all_of(values, [&](double v) { return v >= least && v <= most; });
}

const char* bayesFault(const BayesSettings& settings, const LevelRange& range) {
    if (!std::ranges::all_of(settings.slope, [](double b) { return b > 0.0 && std::isfinite(b); }) ||
        settings.slope.empty())
        return "slope: at least one value above 0";
    if (!allWithin(settings.lapse, 0.0, 0.4))
        return "lapse: at least one value from 0 to 0.4";
    if (!settings.guessIsLapse && !allWithin(settings.guess, 0.0, 0.5))
        return "guess: at least one value from 0 to 0.5";
    if (settings.grid < 4 || settings.grid > 201)
        return "grid: 4 to 201";
    if (settings.priorMean.has_value() != settings.priorSd.has_value())
        return "prior_mean, prior_sd: both or neither";
    if (settings.priorSd && !(*settings.priorSd > 0.0))
        return "prior_sd: above 0";
    if (settings.mostTrials < 1)
        return "most_trials: 1 or more";
    if (settings.sdAtMost && !(*settings.sdAtMost > 0.0))
        return "sd_at_most: above 0";
    if (settings.function == RiseShape::weibull && range.lowest <= 0.0)
        return "function: weibull needs levels above 0";
    return "";
}

} // namespace

const char* toString(EndReason reason) {
    return kEndReasons.of(reason);
}

const char* toString(TrackNote note) {
    return kTrackNotes.of(note);
}

const char* settingsFault(const Procedure& procedure, const LevelRange& range) {
    if (const char* fault = rangeFault(range); *fault != '\0')
        return fault;
    if (const auto* constant = std::get_if<ConstantSettings>(&procedure))
        return constantFault(*constant, range);
    if (const auto* staircase = std::get_if<StaircaseSettings>(&procedure))
        return staircaseFault(*staircase, range);
    return bayesFault(std::get<BayesSettings>(procedure), range);
}

TrackStep nextStep(const Procedure& procedure, const LevelRange& range, std::uint64_t seed,
                   std::span<const KeptTrial> kept) {
    if (*settingsFault(procedure, range) != '\0')
        return TrackEnd{EndReason::badSettings};
    TrackSteps steps(procedure, range, seed);
    for (const KeptTrial& trial : kept) {
        if (trial.counts)
            steps.add(trial);
    }
    return steps.next();
}

std::optional<std::size_t> firstForeignTrial(const Procedure& procedure, const LevelRange& range,
                                             std::uint64_t seed, std::span<const KeptTrial> kept) {
    if (*settingsFault(procedure, range) != '\0')
        return kept.empty() ? std::nullopt : std::optional<std::size_t>(0);
    TrackSteps steps(procedure, range, seed);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (!kept[i].counts)
            continue;
        const TrackStep step = steps.next();
        const auto* next = std::get_if<NextLevel>(&step);
        if (next == nullptr || std::abs(next->level - kept[i].level) > 1e-9 * std::abs(next->level))
            return i;
        steps.add(kept[i]);
    }
    return std::nullopt;
}

} // namespace teleta::study
