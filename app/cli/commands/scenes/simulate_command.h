// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/common/scene_file.h"
#include "backend/servo_figure/servo_curves.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

/// `teleta simulate SCENE.toml`: runs a scene as fast as it can and reports its measures.
class SimulateCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "simulate"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    [[nodiscard]] core::Expected<void> ablate(const app::AnyScene& scene) const;
    [[nodiscard]] core::Expected<std::vector<servo_figure::ServoCurves>> readEarlierRuns() const;
    [[nodiscard]] core::Expected<void> writeFigures(std::vector<servo_figure::ServoCurves> runs) const;

    std::string m_scenePath;
    bool m_list = false;
    std::uint64_t m_seed = 1;
    std::optional<double> m_duration_s;
    std::string m_outFolder;
    bool m_json = false;
    bool m_ablate = false;
    std::uint64_t m_seeds = 8;
    std::vector<std::string> m_figures;
    std::vector<std::string> m_compare; ///< folders of earlier runs
};

} // namespace teleta::cli
