// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/cost_result.h"

#include <optional>
#include <span>

namespace teleta::cost {

/// Marks the rungs that no other one beats: another beats a rung when it is no worse in median time and in
/// mean error and better in one of them. Rungs that are alike in both are on the front together; a rung
/// without a time or an error is not on it and beats none. Thread: any (pure).
void markFrontier(std::span<RungCost> rungs);

/// The rung with the least mean error among those whose calls take no longer than the budget, 99 of 100; of
/// those that are alike the quicker one. Null when none does, and for a budget that is not positive.
/// Thread: any (pure).
[[nodiscard]] const RungCost* bestWithin(std::span<const RungCost> rungs, double budget_s);

/// The quickest rung beside the limit of its ladder.
struct OverLimit {
    const RungCost* fastest = nullptr;
    const RungCost* limit = nullptr;
    double times = 0.0; ///< median time of the fastest over that of the limit
};

/// Empty where the ladder has no limit, or either has no time. Thread: any (pure); points into rungs.
[[nodiscard]] std::optional<OverLimit> overLimit(std::span<const RungCost> rungs);

} // namespace teleta::cost
