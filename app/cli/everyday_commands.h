// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "app/cli/commands/tactile/tactile_commands.h"

#include <vector>

namespace teleta::cli {

/// The commands of the module teleta_everyday, in the order of the help.
inline std::vector<Command> everydayCommands() {
    return {featuresCommand(), contactsCommand(), gainsCommand(), stiffnessCommand(), contourCommand()};
}

} // namespace teleta::cli
