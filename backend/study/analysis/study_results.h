// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"
#include "backend/study/analysis/study_transfer.h"
#include "backend/study/analysis/trial_tally.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// A confusion matrix; participant empty: of all participants together.
struct NamedMatrix {
    std::string participant;
    std::string condition;
    Phase phase = Phase::test;
    ConfusionMatrix matrix;
};

/// One participant under one condition, test phase.
struct ParticipantSummary {
    std::string participant;
    std::string condition;
    ConfusionMatrix matrix;
    std::optional<double> medianTime_s; ///< of correct answers
    std::vector<double> times_s = {};   ///< of correct answers, rising
};

/// All participants under one condition, test phase.
struct GroupSummary {
    std::string condition;
    ConfusionMatrix matrix;
    std::size_t participants = 0;
    std::optional<GroupMean> accuracy = {}; ///< mean of the participants' accuracies, never the pooled share
    std::optional<TransferEstimate> transfer = {}; ///< of the pooled answers
};

/// One row of the ANOVA table, or the reason why there is none.
struct AnovaLine {
    std::string effect;   ///< condition, pattern, condition:pattern
    std::string stimulus; ///< conditions are compared within this pattern; empty: all
    std::optional<AnovaEffect> row;
    std::string note;                 ///< why there is no row; empty otherwise
    std::size_t participants = 0;     ///< with complete data
    std::vector<std::string> dropped; ///< those with a missing cell
};

struct TaskResults {
    std::string task;
    std::vector<std::string>
        patterns; ///< in the order of rows and columns; from a store also those not presented
    std::vector<std::string> conditions;
    std::vector<NamedMatrix> matrices;
    std::vector<ParticipantSummary> participants;
    std::vector<GroupSummary> groups;
    std::vector<AnovaLine> anova;     ///< of the shares of correct answers in each cell
    std::size_t toldAlternatives = 0; ///< number of patterns according to the trials; 0: unknown

    /// Number of patterns to choose from, at least 1.
    [[nodiscard]] std::size_t alternatives() const {
        return std::max({patterns.size(), toldAlternatives, std::size_t{1}});
    }
};

/// Everything that writeResults() writes, by task. Names are sorted, so that the order of the trials does not
/// matter. Empty for an empty tally. Thread: any.
[[nodiscard]] std::vector<TaskResults> studyResults(const TrialTally& tally);

/// Writes confusion_long.csv, summary.csv, group.csv, anova.csv, comparisons.csv, ranks.csv,
/// binomial_model.csv, response_times.csv and analysis.R into a folder, which is created if needed; each file
/// appears when it is complete. Missing values are NA. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeResults(const std::vector<TaskResults>& results,
                                                const std::string& folder);

} // namespace teleta::study
