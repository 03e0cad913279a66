// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>
#include <vector>

namespace teleta::motors {

/// What a motor is told so that its start, lag and curve can be seen: drives that are held for a while each.
struct Excitation {
    struct Step {
        double begin_s = 0.0;
        double drive = 0.0;
    };
    std::vector<Step> steps; ///< times rise from 0
    double duration_s = 0.0;

    /// 0 outside.
    [[nodiscard]] double driveAt(double time_s) const;
};

/// A staircase from rest to the full drive, then pulses of the full and of a medium one. hold_s: of a stair
/// and of a pulse, > 0; longer ones are for motors that are slower than usual.
[[nodiscard]] Excitation stairsAndPulses(double hold_s = 0.3);

/// Columns time_s,commanded at `rate_Hz`: to be put beside what an own sensor records. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeExcitation(const Excitation& excitation, double rate_Hz,
                                                   const std::string& path);

} // namespace teleta::motors
