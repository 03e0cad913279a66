// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"

#include <string>

namespace teleta::cli {

/// `teleta export RECORDING --csv DIR`: the streams of a recording as CSV files.
class ExportCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "export"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::string m_path;
    std::string m_folder;
    bool m_force = false;
    bool m_json = false;
};

} // namespace teleta::cli
