// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/felt/felt_results.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/trial.h"
#include "widgets/study/results/figure_page.h"
#include "widgets/study/results/results_content.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace teleta::study {

/// Thresholds and sensitivity of a study's tasks with levels.
struct LevelResults {
    ThresholdResults thresholds;
    DetectionResults detection;
    std::vector<FeltTask> felt = {};                   ///< the tasks with levels whose stimulus is known
    std::optional<ThresholdResults> withoutRules = {}; ///< of all trials; empty: no rule left one out

    [[nodiscard]] bool has(const QString& task) const;
    [[nodiscard]] bool hasDetection(const QString& task) const;
    /// Null: unknown.
    [[nodiscard]] const FeltTask* feltTask(const QString& task) const;
};

/// Pictures and tables of a task with levels. Pictures share the results. Thread: any (pure).
class LevelContent {
    Q_DECLARE_TR_FUNCTIONS(LevelContent)

public:
    using Shared = std::shared_ptr<const LevelResults>;

    /// Thresholds of all participants, then the curve of each.
    [[nodiscard]] static std::vector<FigureItem> curves(const Shared& results, const QString& task, Mode mode,
                                                        const ConditionNames& names);
    [[nodiscard]] static std::vector<FigureItem> tracks(const Shared& results, const QString& task, Mode mode,
                                                        const ConditionNames& names);
    [[nodiscard]] static std::vector<FigureItem> detection(const Shared& results, const QString& task,
                                                           Mode mode, const ConditionNames& names);
    /// motors: those of the connected bracelet; speed and force are shown where they were measured.
    [[nodiscard]] static TableContent thresholdTable(const LevelResults& results, const QString& task,
                                                     const ConditionNames& names,
                                                     const pattern::MotorProfiles* motors = nullptr);
    /// Why there is no speed and force beside the levels; empty: there is, or levels are no intensities.
    [[nodiscard]] static QString motorNote(const LevelResults& results, const QString& task,
                                           const pattern::MotorProfiles* motors);
    [[nodiscard]] static TableContent trackTable(const LevelResults& results, const QString& task,
                                                 const ConditionNames& names);
    [[nodiscard]] static TableContent detectionTable(const LevelResults& results, const QString& task,
                                                     const ConditionNames& names);
};

} // namespace teleta::study
