// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/figure/svg_canvas.h"
#include "backend/study/analysis/study_results.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Participants' shares of correct answers per condition, their mean with its t interval, and chance.
[[nodiscard]] figure::SvgCanvas accuracyFigure(const TaskResults& task, std::optional<Mode> mode);

/// Mean share of correct answers per pattern, conditions side by side, with t intervals over participants.
[[nodiscard]] figure::SvgCanvas patternFigure(const TaskResults& task, std::optional<Mode> mode);

/// Participants' median response times of correct answers per condition, and the median of these.
[[nodiscard]] figure::SvgCanvas responseTimeFigure(const TaskResults& task, std::optional<Mode> mode);

/// Information transfer of the pooled answers: measured, and without bias with its interval.
[[nodiscard]] figure::SvgCanvas transferFigure(const TaskResults& task, std::optional<Mode> mode);

/// Shares of correct answers for one pattern under one condition, one per participant who was presented it.
[[nodiscard]] std::vector<double> patternAccuracies(const TaskResults& task, const std::string& condition,
                                                    std::size_t pattern);

/// A picture and the name of its file, without an extension.
struct StudyFigure {
    std::string name;
    figure::SvgCanvas picture;
};

/// All pictures of a study: confusion_TASK_CONDITION (percent) and confusion_counts_TASK_CONDITION of all
/// participants in the test phase; accuracy_TASK, patterns_TASK, response_time_TASK,
/// cumulative_time_TASK, transfer_TASK.
/// Characters other than letters a to z, digits, - and _ become _; a number is added where names would
/// collide. Thread: any.
[[nodiscard]] std::vector<StudyFigure> studyFigures(const std::vector<TaskResults>& results,
                                                    std::optional<Mode> mode);

/// A file format of pictures: extension, and conversion from SVG.
struct FigureFormat {
    std::string extension;
    /// Empty: SVG as it is.
    std::function<core::Expected<std::string>(const std::string& svg)> convert = {};
};

/// Writes all pictures into FOLDER/figures, in each format. Error: ioFailed; what a conversion
/// reports. Thread: any.
[[nodiscard]] core::Expected<void> writeFigures(const std::vector<TaskResults>& results,
                                                const std::string& folder, std::optional<Mode> mode = {},
                                                const std::vector<FigureFormat>& formats = {{"svg", {}}});

} // namespace teleta::study
