// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/protocol/trial.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What the cells of a confusion matrix show.
enum class ConfusionValues {
    percent, ///< as the paper's tables: share of the row with one digit, "0", "NA" without trials
    counts,
    both, ///< the share, and below it how many of how many
};

/// A confusion matrix in the layout of the paper's Tables 4-7: rows presented, columns answered, each cell
/// the darker the larger its share of the row. The column NONE appears only if needed. title: above the
/// matrix. mode: any mode but run is written across the picture. Thread: any.
[[nodiscard]] figure::SvgCanvas confusionFigure(const ConfusionMatrix& matrix,
                                                const std::vector<std::string>& patterns,
                                                const std::string& title,
                                                ConfusionValues values = ConfusionValues::percent,
                                                std::optional<Mode> mode = {});

/// The same as a complete file.
[[nodiscard]] std::string confusionSvg(const ConfusionMatrix& matrix,
                                       const std::vector<std::string>& patterns, const std::string& title,
                                       ConfusionValues values = ConfusionValues::percent,
                                       std::optional<Mode> mode = {});

/// Says across a figure that its data are not those of a study: PILOT or SIMULATED; otherwise empty.
[[nodiscard]] QString watermarkOf(std::optional<Mode> mode);

} // namespace teleta::study
