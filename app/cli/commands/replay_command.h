// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"
#include "app/cli/command_io.h"
#include "backend/pipeline/recorded_streams.h"
#include "backend/recording/recording.h"

#include <optional>
#include <string>

namespace teleta::cli {

/// `teleta replay RECORDING`: the array of a recording through the same processing as a device's frames.
class ReplayCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "replay"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    [[nodiscard]] core::Expected<pipeline::RecordedSource>
    chooseSource(const recording::Recording& recording) const;

    std::string m_path;
    std::string m_stream;
    std::optional<double> m_speed;
    std::optional<double> m_threshold;
    RowOptions m_output;
};

} // namespace teleta::cli
