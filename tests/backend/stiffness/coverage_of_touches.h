// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/disturbed_touch.h"
#include "tests/benchmarks/coverage_rows.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace teleta::stiffness::test {

/// What an estimator is told of a disturbed touch.
inline TouchSettings settingsOf(const DisturbedTouch& touch) {
    TouchSettings settings;
    settings.contactDistance_m = touch.told_contactDistance_m;
    settings.contactDistanceSe_m = touch.told_contactDistanceSe_m;
    settings.linkStiffness_NPerM = touch.told_link_NPerM;
    settings.linkStiffnessSe_NPerM = touch.told_linkSe_NPerM;
    return settings;
}

/// The interval, or the bound, holds the truth.
inline bool holds(const Stiffness& object, double truth_NPerM) {
    return object.lower95_NPerM && *object.lower95_NPerM <= truth_NPerM &&
           (!object.upper95_NPerM || truth_NPerM <= *object.upper95_NPerM);
}

/// Width of the 95 % interval of an object, over its stiffness, for white noise alone: least squares of n
/// samples that are spread evenly over the window, 2 1.96 c_i / c_o sd sqrt(12) / (width sqrt(n)).
inline double whiteWidth(double object_NPerM) {
    constexpr double kLink_NPerM = 3468.6;
    constexpr double kWindow_Nm = 0.03;
    const double total_mPerN = 1.0 / object_NPerM + 1.0 / kLink_NPerM;
    const double samples = kWindow_Nm * total_mPerN / (0.17 * 0.17) / 0.005 * 1000.0;
    return 2.0 * 1.96 * total_mPerN * object_NPerM * 0.0005 * std::sqrt(12.0) / kWindow_Nm /
           std::sqrt(samples);
}

/// Coverage of one disturbance over so many touches. overWhite: the widths are over those of white noise
/// alone, instead of over the truth.
inline benchmarks::CoverageRow coverageOf(const DisturbanceName& disturbed, int cases,
                                          std::uint64_t firstSeed, bool overWhite = false) {
    benchmarks::CoverageRow row("stiffness", std::string(disturbed.name));
    for (int i = 0; i < cases; ++i) {
        const DisturbedTouch touch =
            disturbedTouch(disturbed.disturbance, firstSeed + static_cast<std::uint64_t>(i));
        const auto answer = estimateStiffness(touch.log, settingsOf(touch));
        if (!answer) {
            row.addRefused();
            continue;
        }
        const Stiffness& object = answer->object;
        std::optional<double> width;
        if (object.upper95_NPerM)
            width = (*object.upper95_NPerM - *object.lower95_NPerM) / touch.truth_NPerM /
                    (overWhite ? whiteWidth(touch.truth_NPerM) : 1.0);
        row.add(holds(object, touch.truth_NPerM), answer->reliable, width);
    }
    return row;
}

} // namespace teleta::stiffness::test
