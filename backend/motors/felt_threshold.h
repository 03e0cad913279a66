// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/felt_trials.h"

#include <span>

namespace teleta::motors {

/// The drive at which a person says yes as often as no.
struct FeltThreshold {
    double drive = 0.0;
    double lower = 0.0; ///< 95 % interval
    double upper = 0.0;
    double spread = 0.0; ///< of the answers: they go from 27 % to 73 % yes within two of it

    [[nodiscard]] double standardError() const { return (upper - lower) / (2.0 * 1.96); }
};

/// Median and 95 % interval of the threshold, given the answers, with
///   P(yes | drive) = g + (1 - 2 g) / (1 + exp(-(drive - threshold) / spread)),   g = 0.02
/// where g is for slips, every threshold from 0 to 1 was as likely before, and every spread from 0.005 to 0.4
/// on a logarithmic scale. Catch trials do not enter. Source: Watson and Pelli, QUEST (1983), for the prior
/// knowledge. Error: refused: fewer than ten answers, never yes, never no, yes in at least two and half of
/// the catch trials, answers that contradict each other (no better than chance, or a spread above 0.18).
/// Thread: any.
[[nodiscard]] core::Expected<FeltThreshold> estimateThreshold(std::span<const FeltTrial> trials);

} // namespace teleta::motors
