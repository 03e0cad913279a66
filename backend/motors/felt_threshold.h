// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/felt_trials.h"

#include <span>

namespace teleta::motors {

/// The drive at which a person answers yes as often as no.
struct FeltThreshold {
    double drive = 0.0;
    double lower = 0.0; ///< 95 % interval
    double upper = 0.0;
    double spread = 0.0; ///< width of the psychometric function: the share of yes rises from 27 % to 73 %
                         ///< within two spreads

    [[nodiscard]] double standardError() const { return (upper - lower) / (2.0 * 1.96); }
};

/// Estimates the median and the 95 % interval of the threshold given the answers, with
///   P(yes | drive) = g + (1 - 2 g) / (1 + exp(-(drive - threshold) / spread)),   g = 0.02
/// where g allows for slips. The prior is uniform for thresholds from 0 to 1 and for the logarithm of spreads
/// from 0.005 to 0.4. Catch trials are not used for the estimate. Error: refused: fewer than ten answers;
/// never yes or never no; yes in at least two and at least half of the catch trials; contradictory answers
/// (no better than chance, or a spread above 0.18). Thread: any (pure). Source: Watson and Pelli, QUEST
/// (1983), for the use of prior knowledge.
[[nodiscard]] core::Expected<FeltThreshold> estimateThreshold(std::span<const FeltTrial> trials);

} // namespace teleta::motors
