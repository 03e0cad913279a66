// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/methods/adaptive/psychometric_function.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"

#include <cstdint>
#include <optional>
#include <string>

namespace teleta::study {

/// Answers in tasks with levels by a known psychometric function. Each answer depends on the seed and the
/// trial alone. Thread: any (pure).
struct SimulatedObserver {
    std::optional<double> threshold; ///< unit of the level; empty: the middle of the range, or the reference
    std::optional<double> slope; ///< of weibull, or the spread of gauss; empty: 3.5, or a sixth of the range
    double lapse = 0.02;         ///< share of trials that are answered at random, 0 .. 0.5
    double sd = 0.0;             ///< of the threshold between people, in the scale of the levels

    /// Answers to a short question come sooner than those to one of several patterns.
    static constexpr double kMedianResponse_s = 1.0;

    /// Reads "t=0.2,slope=3.5,lapse=0.02,sd=0.1", each part optional; empty text: the usual one. Error:
    /// badInput.
    [[nodiscard]] static core::Expected<SimulatedObserver> parse(const std::string& text);

    /// The function of one person in a task. person: seed that only this person has. Weibull, or gauss where
    /// the procedure or the design has it; its guess rate is chance, or the lapse rate where nothing is
    /// chance.
    [[nodiscard]] PsychometricFunction functionOf(const StudyTask& task, const std::string& condition,
                                                  std::uint64_t person) const;

    /// An answer, as an index of the design's answers. seed: answerSeed() of the trial.
    [[nodiscard]] static std::size_t answer(const PsychometricFunction& function, const StudyTask& task,
                                            const PlannedTrial& trial, std::uint64_t seed);
};

/// Part of a study's seed and a participant's enrolment that only observers use.
[[nodiscard]] std::uint64_t observerSeed(std::uint64_t studySeed, std::size_t enrolment);

} // namespace teleta::study
