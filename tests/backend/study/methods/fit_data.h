// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/fit/psychometric_fit.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::study {

inline std::vector<LevelCount> countsOf(const std::vector<double>& levels, const std::vector<int>& correct,
                                        std::int64_t trials) {
    std::vector<LevelCount> counts;
    for (std::size_t i = 0; i < levels.size(); ++i)
        counts.push_back({levels[i], correct[i], trials});
    return counts;
}

/// Levels of data sets P1 and P4.
inline const std::vector<double> kSixLevels{.02, .04, .06, .08, .12, .16};

inline std::vector<LevelCount> dataP1() {
    return countsOf(kSixLevels, {22, 25, 29, 33, 38, 39}, 40);
}
inline std::vector<LevelCount> dataP2() {
    return countsOf({1, 2, 3, 4, 5, 6, 7}, {0, 2, 5, 9, 15, 19, 20}, 20);
}
inline std::vector<LevelCount> dataP3() {
    return countsOf({.1, .15, .2, .25, .3, .4}, {11, 14, 20, 25, 29, 29}, 30);
}
inline std::vector<LevelCount> dataP4() {
    return countsOf(kSixLevels, {22, 25, 36, 28, 38, 32}, 40);
}

inline FitSettings fitSettings(RiseShape shape, LevelScale scale, std::optional<double> guess,
                               double lapseLow, double lapseHigh) {
    FitSettings settings;
    settings.model = {shape, scale, guess, lapseLow, lapseHigh};
    return settings;
}

} // namespace teleta::study
