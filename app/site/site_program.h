// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>
#include <optional>

namespace teleta::site_program {

/// Keeps SIGTERM, SIGINT and SIGHUP back, so that the program ends in good order: arms held, recording
/// complete. SIGUSR1 and SIGUSR2 are the key for STOP of those at the site: engage it, withdraw it. Make it
/// before there are threads. Thread: any.
class SiteSignals {
public:
    SiteSignals();
    /// Waits so long for one that ends the program; true once one has come. Returns sooner for the others.
    [[nodiscard]] bool wait(std::int64_t longest_ns) const;
    /// Whether STOP was asked for, or withdrawn, since the last call; of both, STOP counts.
    [[nodiscard]] std::optional<bool> takeStop() const;

private:
    enum class Stop { unchanged, engage, withdraw };

    sigset_t m_signals{};
    mutable std::atomic<bool> m_came{false};
    mutable std::atomic<Stop> m_stop{Stop::unchanged};
};

/// Runs teleta-site with these arguments. Exit codes as teleta's: 0 done, 1 the work failed, 2 wrong usage, 3
/// bad input file.
int runProgram(int argc, const char* const* argv, const SiteSignals& sent);

} // namespace teleta::site_program
