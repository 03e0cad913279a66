// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/base/frame_options.h"

namespace teleta::cli {

/// teleta contacts: contacts of recorded frames with their identities, a row a contact of a frame.
class ContactsCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "contacts"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override { m_options.declare(app); }
    [[nodiscard]] core::Expected<void> run() override;

private:
    FrameOptions m_options;
};

} // namespace teleta::cli
