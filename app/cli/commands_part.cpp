// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/arm/arm_commands.h"
#include "app/cli/commands/camera/camera_commands.h"
#include "app/cli/commands/certify/certify_commands.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "app/cli/commands/ros/ros_commands.h"
#include "app/cli/commands/scenes/scene_commands.h"
#include "app/cli/commands/site/site_commands.h"
#include "app/cli/commands/sweep/sweep_commands.h"
#include "app/cli/everyday_commands.h"
#include "app/cli/program.h"
#include "app/cli/program_part.h"

#include <array>
#include <utility>
#include <vector>

namespace {

using namespace teleta::cli;

/// In the order of the help.
std::vector<Command> allCommands() {
    std::vector<Command> commands = everydayCommands();
    for (Command& command :
         std::array{loadsCommand(), calibrateCommand(), locateCommand(), trackCommand(), markersCommand(),
                    simulateCommand(), replayCommand(), exportCommand(), importCommand(), patternCommand(),
                    studyCommand(), tradeoffCommand(), sweepCommand(), armCommand(), devicesCommand(),
                    rosCommand(), certifyCommand(), siteCommand()})
        commands.push_back(std::move(command));
    return commands;
}

} // namespace

const teleta::cli::ProgramPart teleta_commands{
    [](int argc, char** argv) { return runProgram(argc, argv, allCommands); }};
