// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/everyday_commands.h"
#include "app/cli/program.h"
#include "app/cli/program_part.h"

const teleta::cli::ProgramPart teleta_everyday{
    [](int argc, char** argv) { return teleta::cli::runProgram(argc, argv, teleta::cli::everydayCommands); }};
