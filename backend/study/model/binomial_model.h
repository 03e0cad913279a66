// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/model/marginal_likelihood.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::study {

/// Why a model has no numbers. User interfaces put it into words.
enum class ModelRefusal {
    noData,             ///< no trials
    tooFewParticipants, ///< fewer than 5
    separable,    ///< a level is all right or all wrong for everybody: its effect has no finite estimate
    notConverged, ///< the search has found no maximum
    falls,        ///< the share of right answers falls with the level
};

/// Its words in files, logs and tests.
[[nodiscard]] const char* toString(ModelRefusal refusal);

/// The fewest participants of a model.
inline constexpr std::size_t kFewestModelParticipants = 5;
/// The maximum of the likelihood.
struct BinomialFit {
    std::vector<double> b;
    Eigen::MatrixXd covariance; ///< of b, from the curvature at the maximum
    double s = 0.0;             ///< sd of the participants; 0: no more spread between them than chance gives
    double logLikelihood = 0.0;
    std::size_t participants = 0;

    [[nodiscard]] double standardError(std::size_t coefficient) const;
    /// Wald's interval of a coefficient.
    [[nodiscard]] Interval interval(std::size_t coefficient, double confidence = 0.95) const;
};

/// Maximum likelihood over b and s >= 0, from several starting points; s = 0 is an answer. Refusal: noData,
/// tooFewParticipants, separable (a coefficient or s ran away), notConverged. near: b and s of a similar
/// model, from which alone the search starts; null: none is known. Thread: any. Source: Pinheiro and Bates
/// 1995, doi:10.1080/10618600.1995.10474663.
[[nodiscard]] tl::expected<BinomialFit, ModelRefusal> fitBinomial(const BinomialModel& model,
                                                                  const BinomialFit* near = nullptr);

/// The likelihood-ratio test of two nested fits.
struct RatioTest {
    double chi2 = 0.0;
    double df = 0.0;
    double p = 1.0;
};
/// whole has `difference` coefficients more than part, at least 1. Thread: any.
[[nodiscard]] RatioTest ratioTest(const BinomialFit& whole, const BinomialFit& part, std::size_t difference);

} // namespace teleta::study
