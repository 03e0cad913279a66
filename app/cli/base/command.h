// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <functional>
#include <memory>
#include <utility>

namespace CLI {
class App;
}

namespace teleta::cli {

/// One command of the program: `teleta NAME ...`.
struct Command {
    const char* name;
    QString summary;     ///< one line for the list of commands; translated
    const char* example; ///< command lines that work as they are in an empty folder, shown under the help
    std::function<void(CLI::App&)> declare;
    std::function<core::Expected<void>()> run;
};

/// A command whose work is done by an object. Its declare(CLI::App&) declares arguments and options, which
/// are written into its members. Its run() does the work once the command line is parsed: the error decides
/// the exit code (exitCode()); options that contradict each other or the data are refused (refuse()), which
/// is wrong usage.
template <typename Work>
Command makeCommand(const char* name, QString summary, const char* example) {
    auto work = std::make_shared<Work>();
    return {name, std::move(summary), example, [work](CLI::App& app) { work->declare(app); },
            [work] { return work->run(); }};
}

} // namespace teleta::cli
