// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/store/study_connection.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

/// teleta study fit: thresholds, slopes and sensitivity of one study or trial CSV. Thread: main.
class StudyFit {
public:
    void declare(CLI::App& app);
    [[nodiscard]] core::Expected<void> run() const;

private:
    [[nodiscard]] core::Expected<study::FitChoices> choices() const;

    std::string m_input;
    std::string m_server;
    std::string m_function;
    double m_guess = -1.0; ///< below 0: not chosen
    std::string m_lapse;
    std::string m_interval = "profile";
    std::string m_outFolder;
    bool m_json = false;
};

/// Thresholds and sensitivity of the same inputs as those of an analysis.
struct LevelAnalysis {
    study::ThresholdResults thresholds;
    study::DetectionResults detection;
};

/// Reads a study on a server, folders of studies and CSVs, and fits their tasks with levels; empty results
/// where there are none. exclusions: a finished book. Error: what addLevelTrials() reports; cancelled when
/// interrupted.
[[nodiscard]] core::Expected<LevelAnalysis> analyzeLevels(const std::optional<study::StoreLocation>& server,
                                                          const std::vector<std::string>& inputs,
                                                          study::ModeFilter& modes,
                                                          const study::FitChoices& choices,
                                                          const study::ExclusionBook& exclusions);

/// Writes thresholds.csv, levels.csv, sdt.csv and their figures, in these formats of figures.
[[nodiscard]] core::Expected<void> writeLevels(const LevelAnalysis& analysis, const std::string& folder,
                                               std::optional<study::Mode> mode,
                                               const std::vector<std::string>& formats);

} // namespace teleta::cli
