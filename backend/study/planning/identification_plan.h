// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/planning/power.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/protocol/protocol.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// A line of the ANOVA table of a task.
struct PlannedTest {
    std::string task;
    std::string effect;   ///< condition, pattern, condition:pattern
    std::string stimulus; ///< conditions compared within this pattern; empty: over all

    /// "shape:condition", "shape:condition@A".
    [[nodiscard]] std::string name() const;
};

/// A task in which patterns are told apart. Each trial is right or wrong with the truth's share, moved on the
/// logit scale by the participant and by participant x condition; which wrong answer is given changes no test
/// of right answers and is not drawn. Tests are those of studyResults().
class IdentificationPlan : public PossibleStudy {
public:
    /// test: TASK:EFFECT or TASK:condition@PATTERN. Error: badInput where protocol and truth do not have what
    /// the test names, or the task is not an identification.
    [[nodiscard]] static core::Expected<IdentificationPlan>
    make(const Protocol& protocol, const StudyTruth& truth, const std::string& test);

    [[nodiscard]] const PlannedTest& test() const { return m_test; }
    /// Test trials of one participant.
    [[nodiscard]] std::size_t trials() const { return m_logits.size() * m_repetitions; }

    [[nodiscard]] std::vector<double> participant(core::RandomStream& random) const override;
    [[nodiscard]] std::optional<double> p(std::span<const std::vector<double>> participants) const override;

private:
    PlannedTest m_test;
    std::size_t m_conditions = 1;
    std::size_t m_patterns = 2;
    std::size_t m_repetitions = 1;
    std::size_t m_pattern = 0; ///< of a test within one
    double m_participantSd = 0.0;
    double m_participantConditionSd = 0.0;
    std::vector<double> m_logits; ///< of the shares right; condition i, pattern j at i * patterns + j
};

} // namespace teleta::study
