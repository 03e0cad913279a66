// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/sweep/sweep_subject.h"

#include <cstdint>
#include <string>

namespace teleta::sweep {

/// "contact_error_m" of "contact_error_m[2]" and "phases" of "phases.align".
[[nodiscard]] inline std::string baseName(const std::string& measure) {
    return measure.substr(0, measure.find_first_of("[."));
}

/// What a run gave.
struct RunRow {
    std::uint64_t run = 0;
    std::string reason;     ///< why it failed; empty: it did not
    std::uint64_t part = 0; ///< number of the part that it was read from; its frames have the same number
    double wall_s = 0.0;
    double processor_s = 0.0;
    RunMeasures measures;

    [[nodiscard]] bool failed() const { return !reason.empty(); }
};

} // namespace teleta::sweep
