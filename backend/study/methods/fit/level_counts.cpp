// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/level_counts.h"

#include <algorithm>
#include <cmath>

namespace teleta::study {

std::vector<LevelCount> levelCounts(std::span<const KeptTrial> trials) {
    std::vector<LevelCount> counts;
    for (const KeptTrial& trial : trials) {
        if (trial.counts)
            counts.push_back({trial.level, trial.correct ? 1 : 0, 1});
    }
    std::ranges::sort(counts, {}, &LevelCount::level);
    std::vector<LevelCount> grouped;
    for (const LevelCount& one : counts) {
        if (!grouped.empty() && one.level - grouped.back().level <= 1e-9 * std::abs(one.level)) {
            grouped.back().correct += one.correct;
            ++grouped.back().trials;
        } else {
            grouped.push_back(one);
        }
    }
    return grouped;
}

double trendZ(std::span<const LevelCount> counts) {
    double trials = 0.0;
    double correct = 0.0;
    double weighted = 0.0;
    double squares = 0.0;
    double score = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto rank = static_cast<double>(i);
        const auto n = static_cast<double>(counts[i].trials);
        trials += n;
        correct += static_cast<double>(counts[i].correct);
        weighted += n * rank;
        squares += n * rank * rank;
        score += rank * static_cast<double>(counts[i].correct);
    }
    if (trials == 0.0)
        return 0.0;
    const double share = correct / trials;
    const double variance = share * (1.0 - share) * (squares - weighted * weighted / trials);
    return variance > 1e-12 * squares ? (score - share * weighted) / std::sqrt(variance) : 0.0;
}

double loglinearRate(std::int64_t count, std::int64_t trials) {
    return (static_cast<double>(count) + 0.5) / (static_cast<double>(trials) + 1.0);
}

} // namespace teleta::study
