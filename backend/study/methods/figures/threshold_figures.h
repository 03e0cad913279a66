// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/figure/svg_canvas.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/trial.h"

#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What a line of results says, in words of the user's language: "threshold 0.062 (0.045 to 0.08) drive", or
/// why there is none. Thread: any.
[[nodiscard]] QString thresholdWords(const ThresholdLine& line);

/// The answers of one participant at each level (areas by number of trials), the fitted curve with its band,
/// and the threshold with its interval. mode: any mode but run is written across. Thread: any.
[[nodiscard]] figure::SvgCanvas curveFigure(const ThresholdLine& line, std::optional<Mode> mode = {});

/// The levels of a track over its trials: right answers filled, wrong ones hollow; reversals of a staircase,
/// or the posterior mean with its 95 % interval. Thread: any.
[[nodiscard]] figure::SvgCanvas trackFigure(const ThresholdLine& line, std::optional<Mode> mode = {});

/// Thresholds of all participants by condition and track of a task, and their mean with its t interval.
[[nodiscard]] figure::SvgCanvas thresholdsFigure(const ThresholdResults& results, const std::string& task,
                                                 std::optional<Mode> mode = {});

/// d' (filled, with its interval) and c (hollow) of each participant in a condition and track, and the mean
/// d'.
[[nodiscard]] figure::SvgCanvas detectionFigure(const DetectionResults& results, const DetectionGroup& group,
                                                std::optional<Mode> mode = {});

/// A picture and the name of its file, without an extension.
struct ThresholdFigure {
    std::string name;
    figure::SvgCanvas picture;
};

/// All pictures: thresholds_TASK, curve_TASK_CONDITION_TRACK_PARTICIPANT, track_.., detection_TASK_CONDITION_
/// TRACK. Characters other than letters a to z, digits, - and _ become _; a number is added where names would
/// collide. Thread: any.
[[nodiscard]] std::vector<ThresholdFigure> thresholdFigures(const ThresholdResults& thresholds,
                                                            const DetectionResults& detection,
                                                            std::optional<Mode> mode = {});

/// A file format of pictures: extension, and conversion from SVG (empty: as it is).
struct ThresholdFigureFormat {
    std::string extension;
    std::function<core::Expected<std::string>(const std::string& svg)> convert = {};
};

/// Writes all pictures into FOLDER/figures, which is created where there are any. Error: ioFailed; what a
/// conversion reports. Thread: any.
[[nodiscard]] core::Expected<void>
writeThresholdFigures(const ThresholdResults& thresholds, const DetectionResults& detection,
                      const std::string& folder, std::optional<Mode> mode = {},
                      const std::vector<ThresholdFigureFormat>& formats = {{"svg", {}}});

} // namespace teleta::study
