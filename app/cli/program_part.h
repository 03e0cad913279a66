// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::cli {

/// What a module of `teleta` exports: the program with some or all of its commands. A process loads one.
struct ProgramPart {
    /// The whole run, from main's arguments to its exit code.
    int (*run)(int argc, char** argv);
};

} // namespace teleta::cli

extern "C" {
/// All commands, and whatever is said about the program itself.
[[gnu::visibility("default")]] extern const teleta::cli::ProgramPart teleta_commands;
/// The commands that need little: their module loads neither OpenCV nor the libraries of devices.
[[gnu::visibility("default")]] extern const teleta::cli::ProgramPart teleta_everyday;
}
