// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <vector>

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

/// Its words in files, logs and tests.
[[nodiscard]] const char* toString(Refusal refusal);

/// One row of a repeated-measures ANOVA table.
struct AnovaEffect {
    double df1 = 0.0;
    double df2 = 0.0;
    double sumOfSquares = 0.0;
    double errorSumOfSquares = 0.0;
    double f = 0.0;
    double p = 1.0;
    double epsilonGg = 1.0;          ///< Greenhouse and Geisser
    double pGg = 1.0;                ///< p with both degrees of freedom times epsilonGg
    std::optional<double> epsilonHf; ///< Huynh and Feldt, may exceed 1; empty if undefined
    std::optional<double> pHf;       ///< p with min(1, epsilonHf)
    double partialEta2 = 0.0;        ///< SS / (SS + SS error)
    double generalizedEta2 = 0.0;    ///< SS / (SS + all SS of participants and errors)
};

using AnovaRow = tl::expected<AnovaEffect, Refusal>;

/// Values of participants (rows) in the cells of a design (columns): cell (i, j) of factors with a and b
/// levels at i * b + j. NaN: missing.
using ParticipantCells = std::vector<std::vector<double>>;

/// Rows with a missing cell, which an ANOVA leaves out. Thread: any.
[[nodiscard]] std::vector<std::size_t> incompleteParticipants(const ParticipantCells& cells);

/// Two within-participant factors, as in the study: condition x pattern.
struct TwoWayAnova {
    AnovaRow first;
    AnovaRow second;
    AnovaRow interaction;
    std::size_t participants = 0;     ///< with complete data
    std::vector<std::size_t> dropped; ///< rows of participants with a missing cell
};

/// Repeated-measures ANOVA of two factors. Each effect has orthonormal contrasts C; with Z = Y C^T (n x m):
///   SS = n |mean Z|^2,  SS error = sum |Z - mean Z|^2,  F = (SS/m) / (SS error/(m (n-1)))
///   eps GG = tr(S)^2 / (m tr(S S)),  eps HF = (n m eps - 2) / (m (n-1 - m eps)),  S covariance of Z
/// Participants with a missing cell are left out. Rows without F give the reason. Error for the whole table:
/// noData, badShape, tooFewLevels, notFinite, oneParticipant. F and p do not depend on a common factor or
/// offset of the values. Thread: any. Source: Geisser and Greenhouse 1958; Huynh and Feldt 1976; Olejnik and
/// Algina 2003, doi:10.1037/1082-989X.8.4.434.
[[nodiscard]] tl::expected<TwoWayAnova, Refusal>
twoWayAnova(const ParticipantCells& cells, std::size_t firstLevels, std::size_t secondLevels);

/// One within-participant factor.
struct OneWayAnova {
    AnovaRow effect;
    std::size_t participants = 0;
    std::vector<std::size_t> dropped;
};

/// Repeated-measures ANOVA of one factor, one column per level; with two levels F = t^2 of the paired t test.
/// Otherwise as twoWayAnova().
[[nodiscard]] tl::expected<OneWayAnova, Refusal> oneWayAnova(const ParticipantCells& cells);

} // namespace teleta::study
