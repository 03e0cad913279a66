// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/command_io.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/recording.h"
#include "devices/replay/playback_config.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace teleta::cli {

/// `teleta replay RECORDING`: an array of a recording through the same processing as a device's frames, or a
/// camera's pictures.
class ReplayCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "replay"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    using Source = std::variant<pipeline::RecordedSource, pipeline::RecordedCamera>;
    [[nodiscard]] core::Expected<Source> chooseSource(const recording::Recording& recording) const;
    [[nodiscard]] core::Expected<void> replayArray(pipeline::RecordedSource source);
    [[nodiscard]] core::Expected<void> replayCamera(const recording::Recording& recording,
                                                    const pipeline::RecordedCamera& source);
    /// Where the frames of a stream come from.
    [[nodiscard]] replay::RecordedConfig configOf(std::size_t stream) const;

    std::string m_path;
    std::string m_stream;
    std::optional<double> m_speed;
    std::optional<double> m_threshold;
    RowOptions m_output;
};

} // namespace teleta::cli
