// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::study {

/// Why a statistic is undefined. User interfaces put it into words.
enum class Refusal {
    noData,          ///< nothing to evaluate
    notFinite,       ///< a value is infinite
    badShape,        ///< rows of different lengths, or not the number of cells that the design has
    tooFewLevels,    ///< a factor has fewer than two levels
    oneParticipant,  ///< fewer than two participants are complete
    noVariance,      ///< all values of the effect and of its error are the same
    noErrorVariance, ///< the participants agree exactly about the effect, so that F would be infinite
};

/// Name for files, logs and tests.
[[nodiscard]] const char* toString(Refusal refusal);

} // namespace teleta::study
