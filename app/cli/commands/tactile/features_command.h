// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/frame_options.h"

namespace teleta::cli {

/// teleta features: tactile features of recorded frames, a row a frame.
class FeaturesCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "features"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override { m_options.declare(app); }
    [[nodiscard]] core::Expected<void> run() override;

private:
    FrameOptions m_options;
};

} // namespace teleta::cli
