// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/model/binomial_model.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// The model of a task's right answers by condition: logit, a random intercept per participant.
struct AccuracyModel {
    std::string reference;          ///< condition of the intercept
    std::vector<std::string> terms; ///< of the other coefficients: the conditions against the reference
    BinomialFit fit;
    std::optional<RatioTest> condition; ///< of all conditions together; empty with one condition
    std::int64_t trials = 0;
};

/// Fits the test trials of a task. Refusal: as fitBinomial(); separable also where a condition is all right
/// or all wrong for everybody. Thread: any.
[[nodiscard]] tl::expected<AccuracyModel, ModelRefusal> accuracyModel(const TaskResults& task);

} // namespace teleta::study
