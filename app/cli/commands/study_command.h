// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace teleta::study {
class StudyStore;
}

namespace teleta::cli {

/// `teleta study rehearse|resume`: user studies with simulated participants.
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
    [[nodiscard]] core::Expected<void> runRehearse() const;
    [[nodiscard]] core::Expected<void> runResume() const;
    [[nodiscard]] core::Expected<void> goOn(study::StudyStore& store) const;

    CLI::App* m_rehearse = nullptr;
    CLI::App* m_resume = nullptr;
    std::string m_protocolPath;
    std::size_t m_participants = 6;
    std::uint64_t m_seed = 1;
    double m_lapses = 0.0;
    std::string m_outFolder;
    std::string m_studyFolder;
    bool m_json = false;
};

} // namespace teleta::cli
