// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/protocol.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// How often a pattern is answered right.
struct PatternTruth {
    std::string letter;
    double correct = 0.0; ///< share, 0 .. 1, of the middle participant
};

struct ConditionTruth {
    std::string id;
    double correct = 0.0; ///< of all patterns but those below
    std::vector<PatternTruth> patterns;

    [[nodiscard]] double correctOf(const std::string& letter) const;
};

/// What is assumed of the psychometric function in a task with levels.
struct ThresholdTruth {
    double threshold = 0.0; ///< t of the middle participant, unit of the level
    double slope = 3.5;     ///< b of weibull, or the spread of gauss
    double lapse = 0.02;
    double guess = 0.02; ///< of yes_no and same_different; the others have that of their design
    double sd = 0.0;     ///< of the participants' thresholds, on the scale: log10 units where it is log10
};

/// What is assumed of a task: shares of right answers, or a threshold.
struct TaskTruth {
    std::string id;
    double participantSd = 0.0;          ///< of the participants, on the logit scale
    double participantConditionSd = 0.0; ///< of participant x condition, likewise
    std::vector<ConditionTruth> conditions;
    std::optional<ThresholdTruth> threshold = {};
};

/// What is assumed of the tasks of a study when it is planned.
struct StudyTruth {
    std::vector<TaskTruth> tasks;

    void describeKeys(core::Keys& keys);
    /// Null: nothing is assumed of it.
    [[nodiscard]] const TaskTruth* find(const std::string& task) const;
};

/// Reads a truth (TOML). Error: notFound, ioFailed, badInput with file, line, column and what was expected.
/// Thread: any.
[[nodiscard]] core::Expected<StudyTruth> readTruth(const std::string& path);
[[nodiscard]] core::Expected<StudyTruth> parseTruth(std::string_view text, const std::string& file);

/// From the results of a pilot. A share right of k of n is (k + 1/2) / (n + 1), so that no pattern is always
/// right. Spreads come from binomial models with a random intercept: s of the task is that of the
/// participants; what the variance within the single conditions has more is that of participant x condition.
/// Tasks with levels have the mean of their thresholds over participants and tracks, the median of their
/// slopes, and as sd what the hierarchical fit says, or without one the standard deviation of the thresholds,
/// which is too large by the errors of the fits. source: named in errors. Error: refused without results,
/// where a task has no model, for example with fewer than 5 participants, and where no task has a threshold.
/// Thread: any.
[[nodiscard]] core::Expected<StudyTruth>
truthOf(const std::vector<TaskResults>& pilot, const ThresholdResults& thresholds, const std::string& source);
/// The same of a study without levels.
[[nodiscard]] core::Expected<StudyTruth> truthOf(const std::vector<TaskResults>& pilot,
                                                 const std::string& source);

} // namespace teleta::study
