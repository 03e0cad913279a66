// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace teleta::study {

/// Answers as a participant with a known confusion matrix would, after log-normal response times. Confusion,
/// lapses and times have a random stream each: leaving one of them out does not change the others.
/// Thread: any (pure).
struct SimulatedParticipant {
    /// Answers are drawn with the shares of the stimulus' row, from an empty row uniformly. Empty: always
    /// right.
    std::optional<ConfusionMatrix> matrix;
    double lapses = 0.0; ///< probability of not answering, 0 .. 1; 0: nothing is drawn
    double medianResponse_s = 3.0;
    double logSpread = 0.4; ///< standard deviation of the logarithm of the response time; 0: nothing is drawn

    struct Answer {
        std::optional<std::size_t> response; ///< empty: none
        double time_s = 0.0;                 ///< from the onset of the stimulus
    };

    /// seed: answerSeed() of the trial.
    [[nodiscard]] Answer answer(std::size_t stimulus, std::uint64_t seed) const;
    /// The parts of answer().
    [[nodiscard]] std::size_t response(std::size_t stimulus, std::uint64_t seed) const;
    [[nodiscard]] bool isLapse(std::uint64_t seed) const;
    [[nodiscard]] double time_s(std::uint64_t seed) const;
};

/// Seed of a simulated participant's answer to a trial: it depends on the session's seed, the phase, the
/// number and the attempt of the trial alone. Thread: any (pure).
[[nodiscard]] std::uint64_t answerSeed(std::uint64_t sessionSeed, const PlannedTrial& trial);

/// Counts of the paper's Tables 4 to 7, 30 trials a pattern; empty for other tasks and conditions.
/// task: shape, stiffness; condition: static, dynamic. Source: TeleTA, Tables 4-7.
[[nodiscard]] std::optional<ConfusionMatrix> paperMatrix(std::string_view task, std::string_view condition);

/// paperMatrix() where it fits the task, else assumedMatrix(). Thread: any.
[[nodiscard]] ConfusionMatrix knownMatrix(const StudyTask& task, std::string_view condition);

/// A matrix for an unknown task: 7 of 10 answers right, the wrong ones equally often.
[[nodiscard]] ConfusionMatrix assumedMatrix(std::size_t patterns);

} // namespace teleta::study
