// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

namespace teleta::site_program {

/// Keeps SIGTERM, SIGINT and SIGHUP back, so that the program ends in good order: arms held, recording
/// complete. Make it before there are threads. Thread: wait() from any.
class EndSignals {
public:
    EndSignals();
    /// Waits so long for one; true once one has come.
    [[nodiscard]] bool wait(std::int64_t longest_ns) const;

private:
    sigset_t m_signals{};
    mutable std::atomic<bool> m_came{false};
};

/// Runs teleta-site with these arguments. Exit codes as teleta's: 0 done, 1 the work failed, 2 wrong usage, 3
/// bad input file.
int runProgram(int argc, const char* const* argv, const EndSignals& ending);

} // namespace teleta::site_program
