// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/threshold_results.h"

#include "backend/core/number_text.h"
#include "backend/study/methods/adaptive/staircase.h"
#include "backend/study/model/group_threshold.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <thread>

namespace teleta::study {

namespace {

constexpr double kUsualGuessOfYes = 0.02;
/// Of the fit of all participants, in which it is fixed.
constexpr double kUsualLapse = 0.02;

std::vector<KeptTrial> keptOf(const std::vector<LevelTrial>& trials) {
    std::vector<KeptTrial> kept;
    for (const LevelTrial& trial : trials)
        kept.push_back(trial.kept);
    return kept;
}

std::optional<double> guessOf(const LevelTaskFacts& facts, const LevelTrials::Track& track) {
    if (facts.design == Design::interval)
        return 1.0 / static_cast<double>(std::max<std::size_t>(facts.intervals, 2));
    std::int64_t falseAlarms = 0;
    std::int64_t trials = 0;
    for (const LevelTrial& trial : track.trials) {
        if (trial.kept.counts || trial.isExcluded)
            continue;
        ++trials;
        falseAlarms += trial.kept.correct ? 1 : 0;
    }
    return trials > 0 ? loglinearRate(falseAlarms, trials) : kUsualGuessOfYes;
}

bool isConstant(const LevelTaskFacts& facts, const std::vector<LevelCount>& counts) {
    if (!facts.procedure.empty())
        return facts.procedure == "constant";
    return counts.size() > 1 && std::ranges::all_of(counts, [&](const LevelCount& count) {
               return count.trials == counts.front().trials && count.trials > 1;
           });
}

/// The runs of a track, and of each trial its place in the track.
struct Run {
    std::vector<KeptTrial> kept;
    std::vector<std::size_t> places;
};

std::vector<Run> runsOf(const std::vector<LevelTrial>& trials) {
    std::set<std::size_t> numbers;
    for (const LevelTrial& trial : trials)
        numbers.insert(trial.run);
    std::vector<Run> runs;
    for (const std::size_t number : numbers) {
        Run run;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            if (trials[i].run == number) {
                run.kept.push_back(trials[i].kept);
                run.places.push_back(i);
            }
        }
        runs.push_back(std::move(run));
    }
    return runs;
}

void estimateStaircase(const StaircaseSettings& settings, const LevelRange& range,
                       const std::vector<LevelTrial>& trials, ProcedureEstimate& estimate) {
    double sum = 0.0;
    std::size_t count = 0;
    estimate.reversals = 0;
    for (const Run& run : runsOf(trials)) {
        const StaircaseTrack track = staircaseTrack(settings, range, run.kept);
        std::vector<std::size_t> counted;
        for (std::size_t i = 0; i < run.kept.size(); ++i) {
            if (run.kept[i].counts)
                counted.push_back(run.places[i]);
        }
        std::vector<double> levels;
        for (const std::size_t reversal : track.reversals) {
            estimate.reversalTrials.push_back(counted[reversal]);
            levels.push_back(track.levels[reversal]);
        }
        *estimate.reversals += track.reversals.size();
        const auto* end = std::get_if<TrackEnd>(&track.next);
        // A track that was broken off has the estimate of the reversals so far.
        const std::optional<double> own =
            end != nullptr ? end->estimate : reversalEstimate(settings, range.scale, levels);
        const TrackNote note = end != nullptr ? end->note
                               : own          ? TrackNote::none
                                              : TrackNote::tooFewReversals;
        if (estimate.note == TrackNote::none)
            estimate.note = note;
        if (own) {
            sum += onScale(range.scale, *own);
            ++count;
        }
    }
    if (count > 0)
        estimate.staircase = fromScale(range.scale, sum / static_cast<double>(count));
}

void estimateBayes(const BayesSettings& settings, const LevelRange& range,
                   const std::vector<LevelTrial>& trials, ProcedureEstimate& estimate) {
    const BayesGrid grid(settings, range);
    estimate.beliefs.resize(trials.size());
    double sum = 0.0;
    double variance = 0.0;
    const std::vector<Run> runs = runsOf(trials);
    for (const Run& run : runs) {
        BayesTrack track(grid);
        ThresholdBelief belief = track.belief();
        for (std::size_t i = 0; i < run.kept.size(); ++i) {
            if (run.kept[i].counts && !trials[run.places[i]].isExcluded) {
                track.add(run.kept[i].level, run.kept[i].correct);
                belief = track.belief();
            }
            estimate.beliefs[run.places[i]] = belief;
        }
        sum += belief.mean;
        variance += belief.sd * belief.sd;
        if (estimate.note == TrackNote::none)
            estimate.note = belief.note;
    }
    if (runs.empty())
        return;
    const auto count = static_cast<double>(runs.size());
    estimate.bayesMean = fromScale(range.scale, sum / count);
    estimate.bayesSd = std::sqrt(variance) / count;
}

ProcedureEstimate estimateOf(const LevelTaskFacts& facts, const std::vector<LevelTrial>& trials) {
    ProcedureEstimate estimate;
    if (!facts.settings || !facts.range || *settingsFault(*facts.settings, *facts.range) != '\0')
        return estimate;
    if (const auto* staircase = std::get_if<StaircaseSettings>(&*facts.settings))
        estimateStaircase(*staircase, *facts.range, trials, estimate);
    else if (const auto* bayes = std::get_if<BayesSettings>(&*facts.settings))
        estimateBayes(*bayes, *facts.range, trials, estimate);
    return estimate;
}

double lowestLevelOf(const LevelTrials::Track& track) {
    double lowest = 0.0;
    bool any = false;
    for (const LevelTrial& trial : track.trials) {
        if (trial.kept.counts && !trial.isExcluded && (!any || trial.kept.level < lowest)) {
            lowest = trial.kept.level;
            any = true;
        }
    }
    return lowest;
}

void fitLine(ThresholdLine& line, const LevelTrials::Track& track, const FitChoices& choices) {
    line.procedure = estimateOf(line.facts, track.trials);
    line.counts = levelCounts(keptOf(track.left()));
    const std::optional<FitModel> model = fitModelOf(line.facts, track, choices);
    line.guessIsKnown = model.has_value();
    if (!model)
        return;
    line.model = *model;
    line.fit = fitPsychometric(line.counts, {*model, choices.interval, isConstant(line.facts, line.counts),
                                             choices.resamples, choices.seed});
}

/// The fit of all participants at once, beside the mean of their thresholds.
void fitTogether(ThresholdGroup& group, const std::vector<const ThresholdLine*>& lines) {
    HierarchicalThreshold fitted;
    const FitModel& model = lines.front()->model;
    fitted.lapse = model.lapseLow == model.lapseHigh ? model.lapseLow : kUsualLapse;
    std::vector<PersonLevel> rows;
    for (const ThresholdLine* line : lines) {
        if (!line->guessIsKnown) {
            group.withoutHierarchical = "the guess rate is unknown";
            return;
        }
        fitted.guess += line->model.guess.value_or(fitted.lapse) / static_cast<double>(lines.size());
        for (const LevelCount& count : line->counts) {
            if (group.scale == LevelScale::linear || count.level > 0.0)
                rows.push_back(
                    {fitted.participants, onScale(group.scale, count.level), count.correct, count.trials});
        }
        ++fitted.participants;
    }
    const tl::expected<GroupThreshold, ModelRefusal> fit = groupThreshold(rows, fitted.guess, fitted.lapse);
    if (!fit) {
        group.withoutHierarchical = toString(fit.error());
        return;
    }
    fitted.threshold = fromScale(group.scale, fit->threshold);
    if (fit->low)
        fitted.interval.low = fromScale(group.scale, *fit->low);
    if (fit->high)
        fitted.interval.high = fromScale(group.scale, *fit->high);
    fitted.participantSd = fit->participantSd;
    group.hierarchical = fitted;
}

ThresholdGroup groupOf(const std::vector<const ThresholdLine*>& lines) {
    const ThresholdLine& first = *lines.front();
    ThresholdGroup group;
    group.task = first.task;
    group.condition = first.condition;
    group.track = first.track;
    group.facts = first.facts;
    group.reference = first.reference;
    group.function = first.model.shape;
    group.scale = first.model.scale;
    fitTogether(group, lines);
    std::vector<double> places;
    std::vector<double> differences;
    std::vector<double> fractions;
    for (const ThresholdLine* line : lines) {
        if (line->fit.threshold)
            places.push_back(onScale(group.scale, *line->fit.threshold));
        if (const auto difference = line->justNoticeable())
            differences.push_back(*difference);
        if (const auto fraction = line->weber())
            fractions.push_back(*fraction);
    }
    group.participants = places.size();
    group.without = lines.size() - places.size();
    if (const std::optional<GroupMean> mean = groupMean(places)) {
        group.threshold = fromScale(group.scale, mean->mean);
        group.standardDeviation = mean->standardDeviation;
        if (mean->interval)
            group.interval = Interval{fromScale(group.scale, mean->interval->low),
                                      fromScale(group.scale, mean->interval->high)};
    }
    if (const std::optional<GroupMean> mean = groupMean(differences))
        group.justNoticeable = mean->mean;
    if (const std::optional<GroupMean> mean = groupMean(fractions))
        group.weber = mean->mean;
    return group;
}

std::string number(double value) {
    return std::string(core::NumberText(value).view());
}

} // namespace

std::optional<double> ThresholdLine::justNoticeable() const {
    return isComparison() ? fit.justNoticeable(model.shape) : std::nullopt;
}

std::optional<double> ThresholdLine::weber() const {
    const std::optional<double> difference = justNoticeable();
    return difference && reference != 0.0 ? std::optional(*difference / reference) : std::nullopt;
}

std::optional<double> ThresholdLine::equality() const {
    return isComparison() ? fit.threshold : std::nullopt;
}

std::string ThresholdLine::note() const {
    std::string text = guessIsKnown ? toString(fit.note) : "guessUnknown";
    if (guessIsKnown && fit.note == FitNote::belowRange)
        text += " (below " + number(fit.lowestLevel) + ")";
    else if (guessIsKnown && fit.note == FitNote::aboveRange)
        text += " (above " + number(fit.highestLevel) + ")";
    if (procedure.note != TrackNote::none)
        text += (text.empty() ? "" : "; ") + facts.procedure + " " + toString(procedure.note);
    return text;
}

std::string ThresholdGroup::note() const {
    if (without == 0)
        return {};
    return std::to_string(without) + " of " + std::to_string(without + participants) + " without threshold";
}

std::optional<FitModel> fitModelOf(const LevelTaskFacts& facts, const LevelTrials::Track& track,
                                   const FitChoices& choices) {
    FitModel model;
    const double lowest = lowestLevelOf(track);
    model.scale = facts.scale.value_or(usualScale(facts, lowest));
    const bool isComparison = facts.design == Design::compare;
    model.shape = model.scale == LevelScale::log10 && !isComparison ? RiseShape::weibull : RiseShape::gauss;
    model.shape = choices.function.value_or(model.shape);
    if (choices.lapse) {
        model.lapseLow = choices.lapse->first;
        model.lapseHigh = choices.lapse->second;
    }
    if (choices.guess)
        model.guess = choices.guess;
    else if (isComparison)
        model.guess = std::nullopt;
    else if (facts.design)
        model.guess = guessOf(facts, track);
    else if (facts.intervals > 1)
        model.guess = 1.0 / static_cast<double>(facts.intervals);
    else
        return std::nullopt;
    return model;
}

ThresholdResults thresholdResults(const LevelTrials& trials, const FitChoices& choices,
                                  const std::function<bool(std::size_t, std::size_t)>& goOn) {
    ThresholdResults results;
    std::vector<const LevelTrials::Track*> tracks;
    for (const auto& [key, track] : trials.tracks()) {
        if (std::ranges::all_of(track.trials, &LevelTrial::isExcluded))
            continue;
        ThresholdLine line;
        line.participant = key.participant;
        line.task = key.task;
        line.condition = key.condition;
        line.track = key.track;
        line.facts = trials.factsOf(key.task);
        line.reference = track.reference;
        line.interval = choices.interval;
        line.trials = track.trials;
        results.lines.push_back(std::move(line));
        tracks.push_back(&track);
    }
    // Each fit depends on its own data and seed alone, whatever thread has it.
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> stopped = false;
    const auto work = [&](bool reports) {
        for (std::size_t i = next++; i < tracks.size() && !stopped; i = next++) {
            fitLine(results.lines[i], *tracks[i], choices);
            ++done;
            if (reports && goOn && !goOn(done, tracks.size()))
                stopped = true;
        }
    };
    const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < std::min(most, tracks.size()); ++i)
            helpers.emplace_back(work, false);
        work(true);
    }
    if (stopped)
        return {};
    for (std::size_t i = 0; i < results.lines.size();) {
        std::vector<const ThresholdLine*> lines;
        const ThresholdLine& first = results.lines[i];
        for (; i < results.lines.size() && results.lines[i].task == first.task &&
               results.lines[i].condition == first.condition && results.lines[i].track == first.track;
             ++i)
            lines.push_back(&results.lines[i]);
        results.groups.push_back(groupOf(lines));
    }
    return results;
}

} // namespace teleta::study
