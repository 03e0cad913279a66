// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/backend/core/temporary_folder.h"

#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace teleta::test {

struct ProgramResult {
    int exitCode = -1; ///< minus the signal when a signal ended it
    std::string out;
    std::string err;
};

/// How the program is started.
struct ProgramSettings {
    std::vector<std::pair<std::string, std::string>>
        environment;       ///< changes; the locale is C.UTF-8 unless named here
    std::string outPath;   ///< standard output goes to this file; empty: it is kept in ProgramResult::out
    bool terminal = false; ///< standard output and error are a terminal, read as ProgramResult::out
};

/// The program teleta as it is installed, running in a process of its own.
/// Thread: one.
class RunningProgram {
public:
    explicit RunningProgram(const std::vector<std::string>& arguments, const ProgramSettings& settings = {});
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    void send(int signal) const;
    [[nodiscard]] bool ended();
    /// Some regular file that the program has open, also one without a name, holds this text.
    [[nodiscard]] bool hasWritten(std::string_view text) const;
    /// Largest resident memory until now in kB, as the kernel keeps it for this process; 0 when it is not
    /// known.
    [[nodiscard]] long peakMemory_kB() const;
    /// Waits for more output on the terminal and returns all that came until now; the same text again when
    /// the program has closed it.
    [[nodiscard]] const std::string& readTerminal();
    [[nodiscard]] ProgramResult wait();

private:
    bool readTerminalOnce();
    void reap(int options);

    TemporaryFolder m_folder;
    pid_t m_process = -1;
    int m_terminal = -1;
    bool m_ended = false;
    ProgramResult m_result;
};

/// Runs the program to its end.
[[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments,
                                const ProgramSettings& settings = {});

/// Fields of a CSV text, row by row, split at every comma: a second reader that shares no code with the
/// program's.
[[nodiscard]] std::vector<std::vector<std::string>> splitCsv(const std::string& text);

} // namespace teleta::test
