// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/command_io.h"

#include <string>

namespace teleta::cli {

/// teleta track: contacts on the soft tube in a video, or in what a camera sees now, a row a contact of a
/// frame.
class TrackCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "track"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::string m_video;
    std::string m_cameraPath;
    std::string m_preset;
    RowOptions m_output;
};

} // namespace teleta::cli
