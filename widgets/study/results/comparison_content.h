// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/trials/exclusion_results.h"
#include "backend/study/model/task_supplement.h"
#include "widgets/study/results/curve_picture.h"
#include "widgets/study/results/results_content.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace teleta::study {

/// Contents of the tables and pictures of the comparisons of a task. Thread: GUI.
class ComparisonContent {
    Q_DECLARE_TR_FUNCTIONS(ComparisonContent)

public:
    [[nodiscard]] static TableContent pairs(const TaskComparisons& comparisons,
                                            const ConditionNames& names = {});
    [[nodiscard]] static TableContent ranks(const TaskComparisons& comparisons,
                                            const ConditionNames& names = {});
    /// Partial eta squared with its interval, and Friedman's test.
    [[nodiscard]] static TableContent effects(const TaskResults& task, const TaskComparisons& comparisons);
    [[nodiscard]] static TableContent model(const tl::expected<AccuracyModel, ModelRefusal>& model,
                                            const ConditionNames& names = {});
    [[nodiscard]] static QString modelNote(const tl::expected<AccuracyModel, ModelRefusal>& model);
    [[nodiscard]] static TableContent times(const TimeComparisons& times, const ConditionNames& names = {});
    [[nodiscard]] static CurveContent cumulativeTimes(const TaskResults& task,
                                                      const ConditionNames& names = {});
    [[nodiscard]] static TableContent rules(const std::vector<ExclusionLine>& lines);
    /// One task, with the rules and without them.
    [[nodiscard]] static TableContent withAndWithout(const std::string& task,
                                                     const std::vector<TaskResults>& results,
                                                     const std::vector<TaskResults>& withoutRules);
};

} // namespace teleta::study
