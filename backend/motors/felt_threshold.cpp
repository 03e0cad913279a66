// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/felt_threshold.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::motors {

namespace {

struct FeltText {
    Q_DECLARE_TR_FUNCTIONS(FeltThreshold)
};

constexpr std::size_t kFewestAnswers = 10;
constexpr double kSlips = 0.02;
constexpr double kMostSpread = 0.18;
constexpr int kThresholds = 400;
constexpr int kSpreads = 20;
constexpr double kNarrowest = 0.005;
constexpr double kWidest = 0.4;

double logLikelihood(std::span<const FeltTrial> trials, double threshold, double spread) {
    double sum = 0.0;
    for (const FeltTrial& trial : trials) {
        if (trial.isCatch)
            continue;
        const double yes =
            kSlips + (1.0 - 2.0 * kSlips) / (1.0 + std::exp(-(trial.drive - threshold) / spread));
        sum += std::log(trial.yes ? yes : 1.0 - yes);
    }
    return sum;
}

double thresholdAt(int i) {
    return static_cast<double>(i) / kThresholds;
}

double spreadAt(int k) {
    return kNarrowest * std::pow(kWidest / kNarrowest, static_cast<double>(k) / (kSpreads - 1));
}

core::Expected<void> checkAnswers(std::span<const FeltTrial> trials) {
    std::size_t answers = 0;
    std::size_t yes = 0;
    std::size_t catches = 0;
    std::size_t falseAlarms = 0;
    for (const FeltTrial& trial : trials) {
        (trial.isCatch ? catches : answers) += 1;
        if (trial.yes)
            (trial.isCatch ? falseAlarms : yes) += 1;
    }
    if (answers < kFewestAnswers)
        return core::refused(FeltText::tr("There are too few answers: %1.").arg(answers),
                             FeltText::tr("at least %1").arg(kFewestAnswers));
    if (falseAlarms >= 2 && 2 * falseAlarms >= catches)
        return core::refused(
            FeltText::tr("The answer was yes in %1 of %2 cases in which nothing was presented.")
                .arg(falseAlarms)
                .arg(catches),
            FeltText::tr("yes only when something was clearly felt"));
    if (yes == 0)
        return core::refused(FeltText::tr("Nothing was felt, not even at the highest drive."),
                             FeltText::tr("a connected motor in contact with the skin"));
    if (yes == answers)
        return core::refused(FeltText::tr("Everything was felt, even at the lowest drive."),
                             FeltText::tr("no when nothing was felt"));
    return {};
}

} // namespace

core::Expected<FeltThreshold> estimateThreshold(std::span<const FeltTrial> trials) {
    TELETA_CHECK(checkAnswers(trials));
    std::array<std::array<double, kSpreads>, kThresholds + 1> likelihood{};
    double best = -HUGE_VAL;
    for (int i = 0; i <= kThresholds; ++i) {
        for (int k = 0; k < kSpreads; ++k) {
            double& value = likelihood[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
            value = logLikelihood(trials, thresholdAt(i), spreadAt(k));
            best = std::max(best, value);
        }
    }
    // Averaged over all spreads: the most likely one alone would make few answers look more certain than they
    // are.
    std::array<double, kThresholds + 1> sums{};
    double sum = 0.0;
    double spreads = 0.0;
    for (int i = 0; i <= kThresholds; ++i) {
        for (int k = 0; k < kSpreads; ++k) {
            const double weight =
                std::exp(likelihood[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] - best);
            sum += weight;
            spreads += weight * spreadAt(k);
        }
        sums[static_cast<std::size_t>(i)] = sum;
    }
    const auto quantile = [&](double share) {
        const auto found = std::ranges::lower_bound(sums, share * sum);
        return thresholdAt(static_cast<int>(found - sums.begin()));
    };
    FeltThreshold result;
    result.drive = quantile(0.5);
    result.lower = quantile(0.025);
    result.upper = quantile(0.975);
    result.spread = spreads / sum;
    if (result.spread > kMostSpread || result.upper - result.lower > 0.5)
        return core::refused(
            FeltText::tr("The answers contradict each other: stronger was felt less often than "
                         "weaker, or as often."),
            FeltText::tr("consistent answers; undo the wrong ones or start again"));
    return result;
}

} // namespace teleta::motors
