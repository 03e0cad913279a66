// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace teleta::cli {

/// The path by which a command writes standard output.
inline constexpr std::string_view kStandardOutput = "/dev/stdout";

/// Lets the value "-" of an option of text stand for standard input or output, where it names one file; name
/// and type are those of the help. Wrong usage: a folder, a recording (which is a database), a video, a
/// second "-" for one stream. What is read more than once is copied into a temporary file first, which the
/// end of the program removes.
void acceptDash(CLI::Option& option, std::string_view name, std::string_view type);

/// Refuses --json beside a file on standard output. command: the one that was given, with its parts.
/// Throws CLI::ValidationError.
void refuseTwoOutputs(const CLI::App& command);

/// Whether a command writes a file to standard output; what it says to people goes to standard error then.
[[nodiscard]] bool standardOutputIsFile();

} // namespace teleta::cli
