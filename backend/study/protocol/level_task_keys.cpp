// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/level_task_keys.h"

#include "backend/core/bracelet/tactors.h"
#include "backend/core/keys/key_lists.h"
#include "backend/study/methods/adaptive/track.h"
#include "backend/study/protocol/identifier.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace teleta::study {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;
using core::WholeRange;

struct LevelText {
    Q_DECLARE_TR_FUNCTIONS(StudyProtocol)
};

constexpr long long kMostValues = 15;
constexpr long long kMostLevelTrials = 10'000;
constexpr double kLargestStep = 1e6;
/// Guess rates of the designs in which they are unknown.
const std::vector<double> kGuessRates{0.0, 0.05, 0.1, 0.2};
/// Default spreads of gauss and logistic, as shares of the range.
constexpr std::array kSpreadShares{1.0 / 20.0, 1.0 / 12.0, 2.0 / 15.0, 1.0 / 5.0, 1.0 / 3.0};
/// Default lapse rates of comparisons, in which they are guess rates too.
const std::vector<double> kCompareLapses{0.0, 0.02, 0.04};

void refuseKey(Keys& keys, std::string_view key, const QString& message, const QString& expected) {
    keys.refuse(key, message.toStdString(), expected.toStdString());
}

void describeTactors(Keys& keys, std::string_view key, std::vector<std::size_t>& tactors,
                     std::string_view about) {
    std::vector<double> numbers;
    for (const std::size_t tactor : tactors)
        numbers.push_back(static_cast<double>(tactor) + 1.0);
    core::describeList(keys, key, numbers, NumberRange::between(1.0, core::kTactors), {1, core::kTactors},
                       about, Need::optional);
    tactors.clear();
    for (const double number : numbers) {
        const auto tactor = static_cast<std::size_t>(number - 1.0);
        if (number != std::round(number) || std::ranges::find(tactors, tactor) != tactors.end())
            refuseKey(keys, key, LevelText::tr("%1 is not one more tactor").arg(number),
                      LevelText::tr("whole numbers from 1 to %1, each once").arg(core::kTactors));
        tactors.push_back(tactor);
    }
}

void describeTracks(Keys& keys, LevelTask& task, bool hasReference) {
    std::set<std::string> ids;
    keys.tables("track", task.tracks, 0,
                "Series of trials with levels of their own, at most 12; otherwise one",
                [&](Keys& entry, std::vector<LevelTrack>& tracks, std::size_t i) {
                    describeIdentifier(entry, "id", tracks[i].id, ids, "The track's name in results");
                    if (i == kMostTracks)
                        refuseKey(entry, "id", LevelText::tr("there are too many tracks"),
                                  LevelText::tr("at most %1").arg(kMostTracks));
                    describeTactors(entry, "tactors", tracks[i].tactors,
                                    "Tactors that have the stimulus, from 1; otherwise those of the file");
                    if (hasReference)
                        describeTactors(entry, "reference_tactors", tracks[i].reference,
                                        "Tactors that have the reference; otherwise the same");
                });
    if (task.tracks.empty())
        task.tracks = {{"all"}};
}

void describeStimulus(Keys& keys, LevelTask& task) {
    keys.text("file", task.file, "File of the tactile pattern, relative to the protocol");
    keys.choice("vary", task.vary,
                {{"intensity", "All intensities times the level"},
                 {"onset_s", "Time from burst to burst of its only sweep"},
                 {"burst_s", "Length of a burst of its only sweep, ring or pulse train"},
                 {"duration_s", "Length of its only ring, phantom, ramp or pulse train"},
                 {"balance", "Place of its only phantom between its tactors"}},
                "What a level sets");
}

/// The highest level that makes sense for what varies.
double highestOf(Vary vary, double stimulus_s) {
    return vary == Vary::intensity || vary == Vary::balance ? 1.0 : stimulus_s;
}

void checkLevel(Keys& keys, std::string_view key, double level, const LevelRange& range) {
    if (level < range.lowest || level > range.highest)
        refuseKey(keys, key, LevelText::tr("%1 is not among the levels").arg(level),
                  LevelText::tr("from lowest to highest, %1 to %2").arg(range.lowest).arg(range.highest));
}

void describeLevels(Keys& keys, StudyTask& task, double stimulus_s) {
    LevelTask& levels = task.levels;
    const double highest = highestOf(levels.vary, stimulus_s);
    keys.choice("scale", levels.range.scale, {"linear", "log10"},
                "Scale of the steps and of the means of levels", Need::optional);
    keys.number("lowest", levels.range.lowest, NumberRange::notNegative(), "Lowest level");
    keys.number("highest", levels.range.highest, NumberRange::positive(), "Highest level");
    if (levels.range.lowest >= levels.range.highest)
        refuseKey(keys, "lowest", LevelText::tr("the lowest level is not below the highest"),
                  LevelText::tr("a number below %1").arg(levels.range.highest));
    else if (levels.range.scale == LevelScale::log10 && levels.range.lowest <= 0.0)
        refuseKey(keys, "lowest", LevelText::tr("0 has no place on a scale of logarithms"),
                  LevelText::tr("a number above 0, or the scale linear"));
    if (levels.range.highest > highest)
        refuseKey(keys, "highest", LevelText::tr("a level of %1 cannot be shown").arg(levels.range.highest),
                  LevelText::tr("at most %1").arg(highest));
    const bool compares = task.design == Design::compare;
    keys.number("reference", levels.reference, NumberRange::between(0.0, std::max(highest, 0.0)),
                "Level to compare with; 0 is nothing, or a time of 0", Need::optional);
    if (compares && levels.reference <= 0.0 && task.references.size() < task.conditions.size())
        refuseKey(keys, "reference", LevelText::tr("there is nothing to compare with"),
                  LevelText::tr("a reference above 0, here or in each condition"));
    core::describeList(keys, "values", levels.values, NumberRange::notNegative(), {1, kMostValues},
                       "Levels of constant stimuli, rising; a fit needs 3", Need::optional);
    if (std::ranges::adjacent_find(levels.values, std::greater_equal()) != levels.values.end())
        refuseKey(keys, "values", LevelText::tr("the levels do not rise"),
                  LevelText::tr("each level above the one before"));
    for (const double value : levels.values)
        checkLevel(keys, "values", value, levels.range);
    keys.number("practice", levels.practiceLevel, NumberRange::notNegative(),
                "Level of the practice; otherwise the highest");
    if (levels.practiceLevel)
        checkLevel(keys, "practice", *levels.practiceLevel, levels.range);
}

/// Of a design without chance: one right answer down, one wrong one up, at the level of 50 %.
void takeDefaults(StaircaseSettings& staircase, Design design) {
    if (design == Design::yesNo || design == Design::compare) {
        staircase.down = 1;
        staircase.stepUp = staircase.stepDown;
    }
}

void takeDefaults(BayesSettings& bayes, Design design) {
    bayes.guess = kGuessRates;
    if (design != Design::compare)
        return;
    bayes.function = RiseShape::gauss;
    bayes.lapse = kCompareLapses;
}

void describeStaircase(Keys& keys, StaircaseSettings& staircase) {
    keys.number("first", staircase.first, NumberRange::notNegative(), "First level");
    keys.whole("down", staircase.down, {1, 8}, "Right answers in a row before a step down", Need::optional);
    const NumberRange step = NumberRange::positiveUpTo(kLargestStep);
    keys.number("step_up", staircase.stepUp, step, "Step up, in the scale", Need::optional);
    keys.number("step_down", staircase.stepDown, step, "Step down, in the scale", Need::optional);
    keys.whole("fast_reversals", staircase.fastReversals, {0, kMostLevelTrials},
               "Reversals before which steps are larger", Need::optional);
    keys.number("fast_factor", staircase.fastFactor, {.low = 1.0, .high = kLargestStep},
                "How many times larger", Need::optional);
    keys.whole("skip_reversals", staircase.skipReversals, {0, kMostLevelTrials},
               "Reversals that the estimate leaves out", Need::optional);
    keys.whole("reversals", staircase.reversals, {2, kMostLevelTrials}, "Reversals that end the track",
               Need::optional);
    keys.whole("most_trials", staircase.mostTrials, {1, kMostLevelTrials},
               "Trials that end the track, whichever is first", Need::optional);
}

void describeBayes(Keys& keys, BayesSettings& bayes, Design design, const LevelRange& range) {
    keys.choice("function", bayes.function, {"gauss", "logistic", "weibull"},
                "How answers change with the level; otherwise weibull, or gauss for compare", Need::optional);
    if (bayes.function == RiseShape::weibull && range.lowest <= 0.0)
        refuseKey(keys, "function", LevelText::tr("weibull has no place for a level of 0"),
                  LevelText::tr("gauss or logistic, or a lowest level above 0"));
    if (bayes.function != RiseShape::weibull && bayes.slope == BayesSettings().slope) {
        bayes.slope.clear();
        for (const double share : kSpreadShares)
            bayes.slope.push_back(share * (range.highest - range.lowest));
    }
    core::describeList(keys, "slope", bayes.slope, NumberRange::positive(), {1, 30},
                       "Slopes of weibull, or spreads of the others", Need::optional);
    core::describeList(keys, "lapse", bayes.lapse, NumberRange::between(0.0, 0.4), {1, 30},
                       "Shares of mistakes however strong the stimulus is", Need::optional);
    if (design == Design::yesNo)
        core::describeList(keys, "guess", bayes.guess, NumberRange::between(0.0, 0.5), {1, 30},
                           "Shares of yes without a stimulus", Need::optional);
    keys.whole("grid", bayes.grid, {4, 201}, "Levels and thresholds from lowest to highest", Need::optional);
    keys.number("prior_mean", bayes.priorMean, NumberRange::any(),
                "Mean of the thresholds before the first trial, in the scale; without it all are equal");
    keys.number("prior_sd", bayes.priorSd, NumberRange::positive(), "Their standard deviation");
    if (bayes.priorMean.has_value() != bayes.priorSd.has_value())
        refuseKey(keys, bayes.priorMean ? "prior_mean" : "prior_sd",
                  LevelText::tr("a prior needs its mean and its standard deviation"),
                  LevelText::tr("prior_mean and prior_sd"));
    keys.whole("most_trials", bayes.mostTrials, {1, kMostLevelTrials}, "Trials that end the track",
               Need::optional);
    bayes.leastTrials = std::min(bayes.leastTrials, bayes.mostTrials);
    keys.whole("least_trials", bayes.leastTrials, {1, kMostLevelTrials},
               "Trials before which sd_at_most ends nothing", Need::optional);
    keys.number("sd_at_most", bayes.sdAtMost, NumberRange::positive(),
                "Standard deviation of the threshold, in the scale, that ends the track");
}

void describeProcedure(Keys& keys, StudyTask& task) {
    LevelTask& levels = task.levels;
    keys.choose("kind", levels.procedure.index(),
                {{"constant", "Each of `level.values` equally often, in random order"},
                 {"staircase", "Down after right answers, up after a wrong one"},
                 {"bayes", "The level that tells most about threshold and slope (QUEST+)"}},
                "How levels are chosen", Need::required, [&](Keys& same, std::size_t chosen) {
                    if (chosen != levels.procedure.index()) {
                        if (chosen == 0)
                            levels.procedure = ConstantSettings();
                        else if (chosen == 1)
                            takeDefaults(levels.procedure.emplace<StaircaseSettings>(), task.design);
                        else
                            takeDefaults(levels.procedure.emplace<BayesSettings>(), task.design);
                    }
                    if (auto* staircase = std::get_if<StaircaseSettings>(&levels.procedure)) {
                        describeStaircase(same, *staircase);
                        checkLevel(same, "first", staircase->first, levels.range);
                        if (staircase->reversals < staircase->skipReversals + 2)
                            refuseKey(same, "reversals", LevelText::tr("too few reversals for an estimate"),
                                      LevelText::tr("at least %1").arg(staircase->skipReversals + 2));
                    } else if (auto* bayes = std::get_if<BayesSettings>(&levels.procedure)) {
                        describeBayes(same, *bayes, task.design, levels.range);
                    } else if (levels.values.empty()) {
                        refuseKey(same, "kind", LevelText::tr("constant stimuli need their levels"),
                                  LevelText::tr("values in level, 1 to %1 of them").arg(kMostValues));
                    }
                });
}

} // namespace

void describeLevelTask(Keys& keys, StudyTask& task, const Protocol& protocol) {
    LevelTask& levels = task.levels;
    if (protocol.window != ResponseWindow::fromEnd)
        refuseKey(keys, "design",
                  LevelText::tr("answers to this design count from the end of the last interval"),
                  LevelText::tr("response_window = \"from_end\""));
    keys.text("question", levels.question, "What the participant reads; otherwise the usual question",
              Need::optional);
    if (task.design == Design::interval)
        keys.whole("intervals", levels.intervals, {2, kMostIntervals},
                   "Intervals, of which one has the stimulus", Need::optional);
    if (task.design == Design::yesNo)
        keys.number("catch_share", levels.catchShare, NumberRange::between(0.0, 0.5),
                    "Share of the trials that have the reference, or nothing", Need::optional);
    else
        keys.number("gap_s", levels.gap_s, NumberRange::between(0.2, 5.0), "Silence between two intervals",
                    Need::optional);
    describeTracks(keys, levels, task.design != Design::yesNo || levels.catchShare > 0.0);
    keys.table("stimulus", "What is felt", Need::required,
               [&](Keys& table) { describeStimulus(table, levels); });
    keys.table("level", "What the levels are", Need::required,
               [&](Keys& table) { describeLevels(table, task, protocol.stimulus_s); });
    keys.table("procedure", "How the next level is chosen", Need::required,
               [&](Keys& table) { describeProcedure(table, task); });
    task.patterns.clear();
    for (const std::string& answer : answersOf(task.design, levels.intervals))
        task.patterns.push_back({answer, answer});
}

} // namespace teleta::study
