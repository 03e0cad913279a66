// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands/certify/actuator_watch.h"
#include "app/cli/commands/certify/chain_process.h"
#include "app/cli/commands/certify/line_relay.h"
#include "backend/certificate/certificate.h"
#include "backend/core/error.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace teleta::cli {

/// Injects faults, one after the other, into a chain that drives motors or an arm when they begin, and
/// watches those. Waits for what it does; thread: one.
class FaultInjector {
public:
    struct Setup {
        /// How a chain is started that makes this recording: arguments for ChainProcess::start().
        std::function<std::vector<std::string>(const std::string& recording)> chain;
        std::string folder;   ///< of the recordings, which are removed once they were looked at; empty: none
        std::string keptAs;   ///< how the paths of damaged recordings begin, which are kept
        double bound_s = 0.0; ///< motors are to be at zero, and the arm at rest, after this
        std::uint64_t seed = 0;
        /// A program is put to sleep for so long at least: after a shorter silence an arm goes on as long as
        /// the switch is held.
        double leastSleep_s = 0.0;
    };

    /// relay: between chain and driver; null: none, and no fault of a line. watch: of the driver or the arm
    /// itself. Both must outlive this.
    FaultInjector(Setup setup, LineRelay* relay, const ActuatorWatch& watch);

    /// Error: unavailable, when nothing can be made to move within 30 s; cancelled, when interrupted.
    [[nodiscard]] core::Expected<certificate::FaultOutcome> inject(certificate::FaultKind kind);

    /// Ends the chain as an operator does: STOP is released, and nothing moves.
    void finish();

    /// Damaged recordings that were kept.
    [[nodiscard]] const std::vector<std::string>& kept() const { return m_kept; }
    /// Longest time between two looks around a fault.
    [[nodiscard]] double resolution_s() const { return static_cast<double>(m_longestGap_ns) * 1e-9; }

private:
    [[nodiscard]] core::Expected<void> driveAgain();
    [[nodiscard]] core::Expected<void> waitForMotion();
    [[nodiscard]] core::Expected<void> waitForFullDisk();
    void releaseStop();
    void begin(certificate::FaultKind kind);
    void end(certificate::FaultKind kind);
    [[nodiscard]] LineFault anyLie();
    void endChain(certificate::FaultKind kind, certificate::FaultOutcome& outcome);
    void lookAtRecording(certificate::FaultKind kind, certificate::FaultOutcome& outcome);

    Setup m_setup;
    LineRelay* m_relay;
    const ActuatorWatch& m_watch;
    std::mt19937_64 m_random;
    std::unique_ptr<ChainProcess> m_chain; ///< null: none runs
    int m_chains = 0;
    std::int64_t m_clockStep_s = 0; ///< by which the wall clock is wrong
    std::int64_t m_longestGap_ns = 0;
    std::vector<std::string> m_kept;
};

} // namespace teleta::cli
