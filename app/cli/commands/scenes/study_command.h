// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "backend/study/analysis/trial_tally.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::study {
class StudyStore;
struct ModeFilter;
struct TaskResults;
} // namespace teleta::study

namespace teleta::cli {

/// `teleta study rehearse|resume|analyze|export|noise`: user studies with simulated participants, and the
/// results of all.
class StudyCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "study"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    void declareRehearse(CLI::App& app);
    void declareResume(CLI::App& app);
    void declareAnalyze(CLI::App& app);
    void declareExport(CLI::App& app);
    void declareNoise(CLI::App& app);
    void declareStore(CLI::App& app);
    [[nodiscard]] core::Expected<void> runRehearse() const;
    [[nodiscard]] core::Expected<void> runResume() const;
    [[nodiscard]] core::Expected<void> runAnalyze() const;
    [[nodiscard]] core::Expected<void> runExport() const;
    [[nodiscard]] core::Expected<void> runNoise() const;
    [[nodiscard]] core::Expected<void> tallyInputs(study::TrialTally& tally, study::ModeFilter& modes) const;
    [[nodiscard]] core::Expected<void> writeAll(const std::vector<study::TaskResults>& results,
                                                const study::ModeFilter& modes,
                                                const study::TrialTally::Frames& frames) const;
    [[nodiscard]] core::Expected<void> goOn(study::StudyStore& store) const;

    CLI::App* m_rehearse = nullptr;
    CLI::App* m_resume = nullptr;
    CLI::App* m_analyze = nullptr;
    CLI::App* m_export = nullptr;
    CLI::App* m_noise = nullptr;
    std::string m_server;
    std::string m_protocolPath;
    std::size_t m_participants = 6;
    std::uint64_t m_seed = 1;
    double m_lapses = 0.0;
    std::string m_outFolder;
    std::string m_studyFolder;
    std::vector<std::string> m_inputs;
    std::string m_mode;
    std::vector<std::string> m_figures = {"svg"};
    std::string m_format = "psychds";
    double m_level_dBFS = -20.0;
    bool m_json = false;
};

} // namespace teleta::cli
