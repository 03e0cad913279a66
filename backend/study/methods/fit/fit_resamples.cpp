// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/fit_resamples.h"

#include "backend/core/quantile.h"
#include "backend/core/random_stream.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::study {

namespace {

/// Draws the answers of the same trials from a function.
void drawAnswers(std::vector<LevelCount>& counts, std::span<const double> shares,
                 core::RandomStream& random) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i].correct = 0;
        for (std::int64_t trial = 0; trial < counts[i].trials; ++trial)
            counts[i].correct += random.uniform() < shares[i] ? 1 : 0;
    }
}

std::vector<double> sharesAt(std::span<const LevelCount> counts, const PsychometricFunction& function) {
    std::vector<double> shares;
    for (const LevelCount& count : counts)
        shares.push_back(function.shareAt(count.level));
    return shares;
}

double part(double count, double expected) {
    return count == 0.0 ? 0.0 : count * std::log(count / expected);
}

/// Signed roots of the parts of the deviance.
std::vector<double> residuals(std::span<const LevelCount> counts, std::span<const double> shares) {
    std::vector<double> values;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto n = static_cast<double>(counts[i].trials);
        const auto k = static_cast<double>(counts[i].correct);
        const double share = std::clamp(shares[i], 1e-100, 1.0 - 1e-16);
        const double squared = 2.0 * (part(k, n * share) + part(n - k, n * (1.0 - share)));
        values.push_back(std::copysign(std::sqrt(std::max(squared, 0.0)), k - n * share));
    }
    return values;
}

/// Pearson's correlation; empty for fewer than three values or where one list does not vary.
std::optional<double> correlation(std::span<const double> a, std::span<const double> b) {
    if (a.size() < 3)
        return std::nullopt;
    const auto n = static_cast<double>(a.size());
    double meanA = 0.0;
    double meanB = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        meanA += a[i] / n;
        meanB += b[i] / n;
    }
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
        ab += (a[i] - meanA) * (b[i] - meanB);
    }
    if (!(aa > 1e-24) || !(bb > 1e-24))
        return std::nullopt;
    return ab / std::sqrt(aa * bb);
}

/// Share of resamples, the data set itself counted, whose correlation is at least as far from 0.
class CorrelationTest {
public:
    explicit CorrelationTest(std::optional<double> observed)
        : m_observed(observed) {}
    void add(std::optional<double> resample) {
        if (!m_observed || !resample)
            return;
        ++m_resamples;
        m_larger += std::abs(*resample) >= std::abs(*m_observed) ? 1.0 : 0.0;
    }
    [[nodiscard]] std::optional<double> p() const {
        return m_observed ? std::optional((1.0 + m_larger) / (1.0 + m_resamples)) : std::nullopt;
    }

private:
    std::optional<double> m_observed;
    double m_resamples = 0.0;
    double m_larger = 0.0;
};

} // namespace

BootstrapThreshold bootstrapThreshold(std::span<const LevelCount> counts,
                                      const PsychometricFunction& function, const FitSettings& settings) {
    const std::vector<double> shares = sharesAt(counts, function);
    std::vector<LevelCount> drawn(counts.begin(), counts.end());
    core::RandomStream random(settings.seed, "bootstrap");
    const LikelihoodSearch levels(counts, settings.model);
    std::vector<double> thresholds;
    BootstrapThreshold result;
    for (std::size_t b = 0; b < settings.resamples; ++b) {
        drawAnswers(drawn, shares, random);
        if (quickNote(drawn, settings.model) == FitNote::none) {
            const LikelihoodSearch search = levels.withAnswers(drawn);
            const SearchPoint best = search.best();
            if (outsideNote(search, best, drawn, settings.model) == FitNote::none) {
                thresholds.push_back(search.thresholdOf(best.at[SearchPoint::threshold]));
                continue;
            }
        }
        ++result.refused;
    }
    if (thresholds.empty() ||
        static_cast<double>(result.refused) > 0.05 * static_cast<double>(settings.resamples))
        return result;
    std::ranges::sort(thresholds);
    result.interval = {core::quantileOf(thresholds, 0.025), core::quantileOf(thresholds, 0.975)};
    return result;
}

GoodnessOfFit goodnessOfFit(std::span<const LevelCount> counts, const PsychometricFunction& function,
                            double deviance, const FitSettings& settings) {
    std::vector<double> order;
    for (std::size_t i = 0; i < counts.size(); ++i)
        order.push_back(static_cast<double>(i));
    const std::vector<double> shares = sharesAt(counts, function);
    const std::vector<double> residual = residuals(counts, shares);
    GoodnessOfFit result;
    result.residualByShare = correlation(residual, shares);
    result.residualByOrder = correlation(residual, order);
    CorrelationTest byShare(result.residualByShare);
    CorrelationTest byOrder(result.residualByOrder);
    std::vector<LevelCount> drawn(counts.begin(), counts.end());
    core::RandomStream random(settings.seed, "goodness");
    const LikelihoodSearch levels(counts, settings.model);
    std::size_t larger = 0;
    for (std::size_t b = 0; b < settings.resamples; ++b) {
        drawAnswers(drawn, shares, random);
        const LikelihoodSearch search = levels.withAnswers(drawn);
        const SearchPoint best = search.best();
        const double drawnDeviance = 2.0 * (search.saturatedLikelihood() - best.logLikelihood);
        // Equal up to what the search leaves.
        if (drawnDeviance >= deviance - 1e-8)
            ++larger;
        const std::vector<double> again = sharesAt(drawn, search.functionAt(best));
        const std::vector<double> drawnResidual = residuals(drawn, again);
        byShare.add(correlation(drawnResidual, again));
        byOrder.add(correlation(drawnResidual, order));
    }
    result.pDeviance = (1.0 + static_cast<double>(larger)) / (1.0 + static_cast<double>(settings.resamples));
    result.pResidualByShare = byShare.p();
    result.pResidualByOrder = byOrder.p();
    return result;
}

} // namespace teleta::study
