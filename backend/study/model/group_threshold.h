// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/model/binomial_model.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::study {

/// Trials of one participant at one level.
struct PersonLevel {
    std::size_t participant = 0;
    double level = 0.0; ///< in the scale of the fit: log10 of the level where the scale is logarithmic
    std::int64_t correct = 0;
    std::int64_t trials = 0;
};

/// The psychometric function of a group: Psi(x) = g + (1 - g - l) Phi(b0 + b1 x + u_i).
struct GroupThreshold {
    double threshold = 0.0;    ///< where Phi is 1/2 for the middle participant: -b0/b1
    std::optional<double> low; ///< profile interval, 95 %; empty: open
    std::optional<double> high;
    double participantSd = 0.0; ///< sd of the participants' thresholds, s/b1
    BinomialFit fit;            ///< b0, b1, s
};

/// Hierarchical fit of all participants, link Phi. guess, lapse: fixed. The interval holds the thresholds t
/// with 2 (Lmax - Lprofile(t)) <= 3.841459; an end that lies further beyond the levels than their range is
/// open. Refusal: as fitBinomial(); noData with fewer than two levels; falls. Thread: any. Source:
/// Moscatelli, Mezzetti and Lacquaniti 2012, doi:10.1167/12.11.26.
[[nodiscard]] tl::expected<GroupThreshold, ModelRefusal>
groupThreshold(const std::vector<PersonLevel>& trials, double guess, double lapse = 0.02);

} // namespace teleta::study
