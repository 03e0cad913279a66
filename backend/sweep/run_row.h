// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/sweep/sweep_subject.h"

#include <cstdint>
#include <string>

namespace teleta::sweep {

/// What a run gave.
struct RunRow {
    std::uint64_t run = 0;
    std::string reason; ///< why it failed; empty: it did not
    double wall_s = 0.0;
    double processor_s = 0.0;
    RunMeasures measures;

    [[nodiscard]] bool failed() const { return !reason.empty(); }
};

} // namespace teleta::sweep
