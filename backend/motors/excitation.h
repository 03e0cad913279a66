// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>
#include <vector>

namespace teleta::motors {

/// A sequence of drives, each held for a while, from which the start, lag and speed curve of a motor can be
/// identified.
struct Excitation {
    struct Step {
        double begin_s = 0.0;
        double drive = 0.0;
    };
    std::vector<Step> steps; ///< times rise from 0
    double duration_s = 0.0;

    /// Drive at a time, 0 .. 1 of the full drive; 0 before the start and after the end.
    [[nodiscard]] double driveAt(double time_s) const;
};

/// A staircase from rest to the full drive, followed by pulses of the full and of a medium drive. hold_s:
/// duration of a stair and of a pulse, > 0; use a longer one for motors that are slower than usual. Thread:
/// any (pure).
[[nodiscard]] Excitation stairsAndPulses(double hold_s = 0.3);

/// Writes the excitation sampled at rate_Hz as CSV with the columns time_s,commanded, to be combined with the
/// recording of one's own sensor. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeExcitation(const Excitation& excitation, double rate_Hz,
                                                   const std::string& path);

} // namespace teleta::motors
