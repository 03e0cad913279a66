// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/frame_options.h"

#include <string>
#include <vector>

namespace teleta::cli {

/// teleta gains: what each taxel's load is multiplied with, from frames under an even load.
class GainsCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "gains"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::vector<std::string> m_paths;
    ArrayOptions m_array;
    RowOptions m_output;
};

} // namespace teleta::cli
