// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/analysis/proportion.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace teleta::study {

/// Why a study has no interval of its information transfer, only a bound.
enum class TransferDoubt {
    none,            ///< there is an interval
    fewParticipants, ///< fewer than 4
    fewTrials,       ///< fewer than max(20 k, 4 k^2) for k patterns
    fewDifferent,    ///< fewer than 10 answers differ from the most frequent one to their pattern
    likeGuessing,    ///< the answers do not depend on the patterns (G test, p >= 0.05)
};

/// Name for files, logs and tests; "" for none.
[[nodiscard]] const char* toString(TransferDoubt doubt);

/// The reason as a sentence for people, translated; empty for none.
[[nodiscard]] std::string explain(TransferDoubt doubt);

/// Information that the answers of a study's participants carry about the patterns, in bit.
struct TransferEstimate {
    double measured_bit = 0.0;  ///< of the pooled answers, as counted; too high on average
    double corrected_bit = 0.0; ///< without bias; can be below 0
    bool fewTrials = false;     ///< n < 5 k^2 for k patterns
    TransferDoubt doubt = TransferDoubt::none;
    std::optional<Interval> interval = {};  ///< of the true transfer; only without doubt
    std::optional<double> atLeast_bit = {}; ///< lower bound; only for fewDifferent
    std::optional<double> atMost_bit = {};  ///< upper bound; for all other doubts
};

/// Transfer of the pooled answers of several participants, who may differ from each other.
///
/// Corrected value and interval: delete-one-participant jackknife. With T of all n trials, T_-j without the
/// n_j trials of participant j, h_j = n / n_j and m participants:
///   T' = m T - sum_j (1 - n_j/n) T_-j
///   se^2 = 1/m sum_j (h_j T - (h_j - 1) T_-j - T')^2 / (h_j - 1)
///   T' +- t(m - 1) se, within 0 .. entropy of the patterns presented
/// One participant: informationTransfer(), the jackknife over trials.
/// Bounds of 95 %: at least, where few answers differ: Fano's inequality, with the upper limit of Clopper and
/// Pearson for the share of wrong answers, their number divided by the design effect between participants;
/// at most: T + 1.645 se, se the larger of the jackknife's and that of independent trials; where the G test
/// finds nothing, at least 1/(2 n ln 2) times the noncentrality with which G is as small as this in 5 %.
/// participants: a matrix each, all of the same size; those without trials do not count. alternatives: number
/// of patterns, if the matrices have fewer. Coverage of the intervals: 92 to 96 % (README.md). Empty
/// without trials. Thread: any. Sources: Tukey 1958; Busing, Meijer and van der Leeden 1999,
/// doi:10.1023/A:1008800423698 (groups of different size); Cover and Thomas, Elements of Information Theory,
/// section 2.10 (Fano); Agresti, Categorical Data Analysis, section 6.6 (noncentral chi-squared).
[[nodiscard]] std::optional<TransferEstimate> studyTransfer(std::span<const ConfusionMatrix> participants,
                                                            std::size_t alternatives = 0);

} // namespace teleta::study
