// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/fit/psychometric_fit.h"
#include "backend/study/methods/results/level_trials.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::study {

/// What a user chose for all fits; the rest follows from the design.
struct FitChoices {
    std::optional<RiseShape> function;
    std::optional<double> guess;                    ///< 0 .. below 1
    std::optional<std::pair<double, double>> lapse; ///< lowest and highest, equal: fixed; 0 .. below 0.5
    FitInterval interval = FitInterval::profile;
    std::size_t resamples = 2000;
    std::uint64_t seed = 1; ///< of resamples
};

/// What an adaptive procedure itself says of a track; needs the protocol's settings.
struct ProcedureEstimate {
    std::optional<double> staircase;         ///< mean of its runs on the scale, unit of the level
    std::optional<std::size_t> reversals;    ///< of all runs
    std::optional<double> bayesMean;         ///< mean of its runs on the scale, unit of the level
    std::optional<double> bayesSd;           ///< on the scale; of several runs that of their mean
    std::vector<std::size_t> reversalTrials; ///< indices of LevelTrials::Track::trials
    std::vector<ThresholdBelief> beliefs;    ///< bayes: after each trial of the track, catch trials too
    TrackNote note = TrackNote::none;        ///< of the first run that has one
};

/// A threshold of one participant.
struct ThresholdLine {
    std::string participant;
    std::string task;
    std::string condition;
    std::string track;
    LevelTaskFacts facts;
    double reference = 0.0;
    FitModel model;
    FitInterval interval = FitInterval::profile;
    bool guessIsKnown = true; ///< false: the table has no design, and no guess rate was chosen; no fit
    PsychometricFit fit;
    std::vector<LevelCount> counts;
    std::vector<LevelTrial> trials; ///< excluded ones too
    ProcedureEstimate procedure;

    [[nodiscard]] bool isComparison() const { return facts.design == Design::compare; }
    /// Of comparisons: just noticeable difference, and over the reference; the point of subjective equality.
    [[nodiscard]] std::optional<double> justNoticeable() const;
    [[nodiscard]] std::optional<double> weber() const;
    [[nodiscard]] std::optional<double> equality() const;
    /// Words of fit and procedure: "aboveRange (above 0.16)", "slopeAtLimit; tooFewReversals"; empty: none.
    [[nodiscard]] std::string note() const;
};

/// All participants in one fit, in which each has a threshold of their own; its function is gauss on the
/// scale, see groupThreshold().
struct HierarchicalThreshold {
    std::size_t participants = 0; ///< also those without a threshold of their own
    double threshold = 0.0;       ///< of the middle participant, unit of the level
    OpenInterval interval;        ///< profile, 95 %
    double participantSd = 0.0;   ///< of the thresholds, in the scale: log10 units where it is log10
    double guess = 0.0;           ///< 1/m of intervals, l of comparisons, else the participants' mean
    double lapse = 0.0;           ///< 0.02, or the fixed one that was chosen
};

/// All participants in one condition and track. Thresholds are averaged on the scale.
struct ThresholdGroup {
    std::string task;
    std::string condition;
    std::string track;
    LevelTaskFacts facts;
    double reference = 0.0;
    RiseShape function = RiseShape::weibull;
    LevelScale scale = LevelScale::log10;
    std::size_t participants = 0;            ///< with a threshold
    std::size_t without = 0;                 ///< without one, left out
    std::optional<double> threshold;         ///< unit of the level
    std::optional<double> standardDeviation; ///< of the thresholds, on the scale
    std::optional<Interval> interval;        ///< of Student's t, unit of the level
    std::optional<double> justNoticeable;    ///< mean
    std::optional<double> weber;             ///< mean
    std::optional<HierarchicalThreshold> hierarchical;
    std::string withoutHierarchical; ///< why there is none: "fewer than 5 participants", ..

    [[nodiscard]] bool isComparison() const { return facts.design == Design::compare; }
    [[nodiscard]] std::string note() const;
};

struct ThresholdResults {
    std::vector<ThresholdLine> lines;   ///< by task, condition, track, participant
    std::vector<ThresholdGroup> groups; ///< by task, condition, track

    [[nodiscard]] bool empty() const { return lines.empty(); }
};

/// What a track is fitted with. Guess rate: 1/m of intervals; yes_no the log-linear share of yes in catch
/// trials, or 0.02 without; same_different likewise of "different"; compare g = l. Lapse rate free in
/// 0 .. 0.06. Function: weibull for detection on a log10 scale, else gauss. Empty: the guess rate is not
/// known. Thread: any (pure).
[[nodiscard]] std::optional<FitModel> fitModelOf(const LevelTaskFacts& facts, const LevelTrials::Track& track,
                                                 const FitChoices& choices);

/// Fits every participant, condition and track, on as many threads as there are processors. Trials of several
/// participants are never taken together; excluded ones are left out, but a staircase is the run as it was. p
/// of the deviance for constant stimuli only; where a table does not name the procedure, for levels that were
/// shown equally often. goOn: called between fits with how many of how many are done; false stops and what is
/// done is dropped. Thread: any.
[[nodiscard]] ThresholdResults
thresholdResults(const LevelTrials& trials, const FitChoices& choices = {},
                 const std::function<bool(std::size_t done, std::size_t all)>& goOn = {});

} // namespace teleta::study
