// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/sweep/sweep_plan.h"
#include "backend/sweep/sweep_results.h"
#include "backend/sweep/sweep_runner.h"

#include <cstdint>

namespace teleta::cli {

/// Shows on a terminal how far a sweep has come, the time left and the worst cells; nothing elsewhere.
/// Thread: one.
class SweepScreen {
public:
    explicit SweepScreen(const sweep::SweepPlan& plan);
    ~SweepScreen() { erase(); }
    SweepScreen(const SweepScreen&) = delete;
    SweepScreen& operator=(const SweepScreen&) = delete;

    void update(const sweep::SweepProgress& progress);
    void erase();

private:
    const sweep::SweepPlan& m_plan;
    bool m_shown;
    int m_lines = 0; ///< that are on the screen
    std::int64_t m_next_ns = 0;
};

/// On standard output: fields and, of each measure, the range of its means; or one JSON document,
///   {"folder","runs","done","failed","cells":[{"cell","settings":{},"runs","failed","measures":{NAME:
///   {"n","mean","sd","median","p05","p95","low95","high95"}}}]}
[[nodiscard]] core::Expected<void> printSweep(const sweep::SweepPlan& plan,
                                              const sweep::SweepResults& results, const std::string& folder,
                                              bool json);

} // namespace teleta::cli
