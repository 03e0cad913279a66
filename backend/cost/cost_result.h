// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cost {

/// Name of the rung that says how little time the job can take, see limitRung().
inline constexpr std::string_view kLimitName = "limit";

/// What a rung's accuracy costs, measured.
struct RungCost {
    std::string name;
    std::string parameter;
    double errorMean = 0.0; ///< NaN: the rung has none
    double errorP95 = 0.0;
    double errorMax = 0.0;
    double timeMedian_s = 0.0; ///< of one call; NaN: refused, the machine was too noisy
    /// NaN: refused. Where calls are so short that a trial puts many of them together, this is of their
    /// means.
    double timeP99_s = 0.0;
    std::size_t samples = 0; ///< timed trials
    /// How unevenly the machine ran meanwhile: see measureLadders(). NaN: not known (read from a file).
    double spread = 0.0;
    bool pareto = false; ///< no other rung is both as quick and as exact

    /// Its times may be used.
    [[nodiscard]] bool isTimed() const { return timeMedian_s == timeMedian_s; }
    [[nodiscard]] bool isLimit() const { return name == kLimitName; }
};

/// The rungs of one ladder, measured in one run on one machine.
struct LadderCost {
    std::string ladder;
    std::string errorUnit;
    std::vector<RungCost> rungs;
};

} // namespace teleta::cost
