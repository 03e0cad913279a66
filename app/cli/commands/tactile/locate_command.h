// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/command_io.h"

#include <string>

namespace teleta::cli {

/// teleta locate: points on the cylinder that pixels of a calibrated camera show, a row a pixel.
class LocateCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "locate"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::string m_cameraPath;
    std::string m_pixelsPath;
    RowOptions m_output;
};

} // namespace teleta::cli
