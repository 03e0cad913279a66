// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

namespace CLI {
class App;
}

namespace teleta::cli {

/// One command of the program: `teleta NAME ...`.
class Command {
public:
    virtual ~Command() = default;
    Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    [[nodiscard]] virtual const char* name() const = 0;
    /// One line for the list of commands; translated.
    [[nodiscard]] virtual QString summary() const = 0;
    /// Command lines that work as they are in an empty folder, shown under the command's help.
    [[nodiscard]] virtual const char* example() const = 0;

    /// Declares arguments and options, which are written into members of this object.
    virtual void declare(CLI::App& app) = 0;

    /// Does the work after the command line was parsed. The error decides the exit code (exitCode()); options
    /// that contradict each other or the data throw CLI::ValidationError, which is wrong usage.
    [[nodiscard]] virtual core::Expected<void> run() = 0;
};

} // namespace teleta::cli
