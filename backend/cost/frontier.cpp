// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/frontier.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace teleta::cost {

namespace {

bool isComplete(const RungCost& rung) {
    return rung.isTimed() && !std::isnan(rung.errorMean);
}

bool beats(const RungCost& a, const RungCost& b) {
    return a.timeMedian_s <= b.timeMedian_s && a.errorMean <= b.errorMean &&
           (a.timeMedian_s < b.timeMedian_s || a.errorMean < b.errorMean);
}

} // namespace

void markFrontier(std::span<RungCost> rungs) {
    for (RungCost& rung : rungs)
        rung.pareto = isComplete(rung) && std::ranges::none_of(rungs, [&](const RungCost& other) {
                          return isComplete(other) && beats(other, rung);
                      });
}

const RungCost* bestWithin(std::span<const RungCost> rungs, double budget_s) {
    const RungCost* best = nullptr;
    if (!(budget_s > 0.0))
        return best;
    for (const RungCost& rung : rungs) {
        if (!isComplete(rung) || std::isnan(rung.timeP99_s) || rung.timeP99_s > budget_s)
            continue;
        if (best == nullptr ||
            std::tie(rung.errorMean, rung.timeMedian_s) < std::tie(best->errorMean, best->timeMedian_s))
            best = &rung;
    }
    return best;
}

std::optional<OverLimit> overLimit(std::span<const RungCost> rungs) {
    OverLimit over;
    for (const RungCost& rung : rungs) {
        if (!rung.isTimed())
            continue;
        if (rung.isLimit())
            over.limit = &rung;
        else if (over.fastest == nullptr || rung.timeMedian_s < over.fastest->timeMedian_s)
            over.fastest = &rung;
    }
    if (over.fastest == nullptr || over.limit == nullptr || !(over.limit->timeMedian_s > 0.0))
        return std::nullopt;
    over.times = over.fastest->timeMedian_s / over.limit->timeMedian_s;
    return over;
}

} // namespace teleta::cost
