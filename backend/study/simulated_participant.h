// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/confusion_matrix.h"
#include "backend/study/portable_random.h"

#include <optional>
#include <string_view>
#include <vector>

namespace teleta::study {

/// Answers as a participant with a known confusion matrix would.
/// Response times are log-normal. Thread: any.
struct SimulatedParticipant {
    ConfusionMatrix matrix; ///< answers come with the shares of the stimulus' row; an empty row is guessed
    double lapses = 0.0;    ///< probability of not answering at all, 0 .. 1
    double medianResponse_s = 3.0;
    double logSpread = 0.4; ///< standard deviation of the logarithm of the response time

    struct Answer {
        std::optional<std::size_t> response; ///< empty: none at all
        double time_s = 0.0;                 ///< from the onset of the stimulus
    };

    [[nodiscard]] Answer answer(std::size_t stimulus, PortableRandom& random) const;
};

/// Counts of the paper's Tables 4 to 7, 30 trials a pattern; empty for other tasks and conditions.
/// task: shape, stiffness; condition: static, dynamic. Source: TeleTA, Tables 4-7.
[[nodiscard]] std::optional<ConfusionMatrix> paperMatrix(std::string_view task, std::string_view condition);

/// A matrix for a task of which nothing is known: 7 of 10 right, the other answers equally often.
[[nodiscard]] ConfusionMatrix assumedMatrix(std::size_t patterns);

} // namespace teleta::study
