// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/certificate/fault_kind.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::certificate {

/// What moves.
enum class Actuator {
    motors, ///< of a bracelet; at zero when they are off
    arm,    ///< at zero when it is at rest
};

/// What one fault did.
struct FaultOutcome {
    FaultKind kind = FaultKind::stop;
    /// From the fault, or from the STOP that followed it, until the actuator was seen at zero and stayed
    /// there; empty: it was not when the watching ended.
    std::optional<double> zero_s{};
    /// It moved again although nobody had asked.
    bool restarted = false;
    /// Frames that the program had said were safe and that are not in the recording.
    std::uint64_t framesLost = 0;
    /// The recording cannot be read, or was not completed where it should have been.
    bool fileDamaged = false;
};

/// The program and the computer that were looked at.
struct CertifiedSystem {
    std::string version; ///< of the program, with the commit
    Actuator actuator = Actuator::motors;
    std::string driver;        ///< name of the driver of the motors, or of the arm
    bool simulated = true;     ///< the driver is a simulated one
    std::string started;       ///< UTC, ISO 8601
    std::string kernel;        ///< name and release
    std::string processor;     ///< its name; empty: not known
    int cores = 0;             ///< that the program may use
    double load = 0.0;         ///< processes that wanted to run, mean of the last minute, at the end
    double resolution_s = 0.0; ///< longest time between two looks that were used
};

/// Of the faults of one kind.
struct FaultTally {
    FaultKind kind = FaultKind::stop;
    std::size_t faults = 0;
    std::size_t notZero = 0;   ///< still on when the watching ended
    std::size_t overBound = 0; ///< later than the bound, with notZero
    std::size_t restarted = 0;
    std::uint64_t framesLost = 0;
    std::size_t filesDamaged = 0;
    std::optional<double> median_s{}; ///< of those that came to zero, as the next two; type 7
    std::optional<double> p99_s{};
    std::optional<double> longest_s{};
};

/// Faults of a system and what they did. A pure value; thread: any.
struct Certificate {
    CertifiedSystem system;
    double bound_s = 0.15; ///< the actuator is to be at zero after this
    std::uint64_t seed = 0;
    std::vector<FaultOutcome> outcomes;
    std::vector<std::string> remarks; ///< what was not done, and why; for people

    /// One for each kind that occurs, in the order of kFaultKinds.
    [[nodiscard]] std::vector<FaultTally> tallies() const;
    /// Of all kinds together.
    [[nodiscard]] FaultTally total() const;
    /// There were faults, all came to zero within the bound, nothing drove unasked and nothing was lost.
    [[nodiscard]] bool passes() const;
};

/// The share of such faults that lasts longer than the bound is at most this, with a confidence of 95 %:
/// the upper limit of Clopper and Pearson (1934), one-sided. 1 without faults.
[[nodiscard]] double shareOverBoundAtMost(const FaultTally& tally);

/// {"passes": .., "bound_s": .., "system": {..}, "kinds": [..], "faults": [..]}; see the handbook.
[[nodiscard]] nlohmann::ordered_json toJson(const Certificate& certificate);

} // namespace teleta::certificate
