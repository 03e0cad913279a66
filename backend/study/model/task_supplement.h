// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/comparison/time_comparisons.h"
#include "backend/study/model/accuracy_model.h"

namespace teleta::study {

/// What goes beyond the ANOVA of a task: comparisons, response times, the model of single answers. It takes
/// some hundredths of a second, so that a window has it computed elsewhere.
struct TaskSupplement {
    TaskComparisons comparisons;
    TimeComparisons times;
    tl::expected<AccuracyModel, ModelRefusal> model = tl::unexpected(ModelRefusal::noData);
};

/// Thread: any.
[[nodiscard]] inline TaskSupplement taskSupplement(const TaskResults& task) {
    return {taskComparisons(task), timeComparisons(task), accuracyModel(task)};
}

} // namespace teleta::study
