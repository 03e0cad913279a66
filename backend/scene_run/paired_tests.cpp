// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/paired_tests.h"

#include "backend/core/random_stream.h"
#include "backend/scene_run/base/scene_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace teleta::scene_run {

namespace {

constexpr std::size_t kMostExact = 16;
constexpr std::uint64_t kDrawn = 20'000;
constexpr double kSame = 1.0 - 1e-12; ///< sums of the same numbers in another order

double sumWithSigns(std::span<const double> differences, std::uint64_t signs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < differences.size(); ++i)
        sum += (signs >> i & 1U) != 0 ? -differences[i] : differences[i];
    return std::abs(sum);
}

double drawnSum(std::span<const double> differences, core::RandomStream& random) {
    double sum = 0.0;
    for (const double difference : differences)
        sum += random.below(2) != 0 ? -difference : difference;
    return std::abs(sum);
}

} // namespace

double pairedMeanTest(std::span<const double> differences) {
    if (differences.size() < 2 ||
        !std::ranges::all_of(differences, [](double d) { return std::isfinite(d); }))
        return std::numeric_limits<double>::quiet_NaN();
    const double seen = kSame * sumWithSigns(differences, 0);
    std::uint64_t farther = 0;
    if (differences.size() <= kMostExact) {
        const std::uint64_t all = 1ULL << differences.size();
        for (std::uint64_t signs = 0; signs < all; ++signs)
            farther += sumWithSigns(differences, signs) >= seen ? 1 : 0;
        return static_cast<double>(farther) / static_cast<double>(all);
    }
    core::RandomStream random(1, "paired mean test");
    for (std::uint64_t i = 0; i < kDrawn; ++i)
        farther += drawnSum(differences, random) >= seen ? 1 : 0;
    // The observed signs are one more of the possible ones.
    return static_cast<double>(farther + 1) / static_cast<double>(kDrawn + 1);
}

double pairedSpreadTest(std::span<const double> a, std::span<const double> b) {
    if (a.size() != b.size())
        return std::numeric_limits<double>::quiet_NaN();
    const double middleA = quantile({a.begin(), a.end()}, 0.5);
    const double middleB = quantile({b.begin(), b.end()}, 0.5);
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i)
        differences.push_back(std::abs(a[i] - middleA) - std::abs(b[i] - middleB));
    return pairedMeanTest(differences);
}

} // namespace teleta::scene_run
