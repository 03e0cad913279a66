// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/simulated_participant.h"

#include <cmath>
#include <numbers>

namespace teleta::study {

namespace {

using Counts = std::vector<std::vector<int>>;

ConfusionMatrix matrixOf(const Counts& counts) {
    ConfusionMatrix matrix(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t j = 0; j < counts[i].size(); ++j)
            matrix.add(i, j, counts[i][j]);
    }
    return matrix;
}

} // namespace

SimulatedParticipant::Answer SimulatedParticipant::answer(std::size_t stimulus,
                                                          PortableRandom& random) const {
    // Everything is drawn in every trial, so that one answer does not move the following ones.
    const bool lapse = random.unit() < lapses;
    const double choice = random.unit();
    const double radius = std::sqrt(-2.0 * std::log1p(-random.unit()));
    const double normal = radius * std::cos(2.0 * std::numbers::pi * random.unit());
    Answer answer{std::nullopt, medianResponse_s * std::exp(logSpread * normal)};
    if (lapse)
        return answer;
    const std::int64_t total = matrix.rowTotal(stimulus);
    if (total == 0) {
        answer.response = static_cast<std::size_t>(choice * static_cast<double>(matrix.patterns()));
        return answer;
    }
    auto left = static_cast<std::int64_t>(choice * static_cast<double>(total));
    for (std::size_t column = 0; column < matrix.patterns(); ++column) {
        left -= matrix.count(stimulus, column);
        if (left < 0) {
            answer.response = column;
            break;
        }
    }
    return answer;
}

std::optional<ConfusionMatrix> paperMatrix(std::string_view task, std::string_view condition) {
    if (task == "shape" && condition == "dynamic")
        return matrixOf({{30, 0, 0, 0, 0, 0},
                         {0, 25, 4, 0, 0, 1},
                         {0, 1, 29, 0, 0, 0},
                         {1, 0, 0, 22, 3, 4},
                         {1, 1, 1, 1, 26, 0},
                         {0, 1, 0, 0, 1, 28}});
    if (task == "shape" && condition == "static")
        return matrixOf({{18, 8, 2, 1, 1, 0},
                         {10, 8, 8, 1, 3, 0},
                         {3, 10, 13, 0, 4, 0},
                         {0, 1, 2, 23, 3, 1},
                         {0, 3, 6, 5, 16, 0},
                         {0, 0, 0, 0, 1, 29}});
    if (task == "stiffness" && condition == "dynamic")
        return matrixOf(
            {{30, 0, 0, 0, 0}, {0, 24, 4, 2, 0}, {0, 5, 22, 3, 0}, {0, 0, 6, 21, 3}, {0, 0, 0, 1, 29}});
    if (task == "stiffness" && condition == "static")
        return matrixOf(
            {{22, 6, 2, 0, 0}, {4, 15, 5, 6, 0}, {0, 5, 15, 6, 4}, {0, 0, 7, 16, 7}, {0, 0, 2, 7, 21}});
    return std::nullopt;
}

ConfusionMatrix assumedMatrix(std::size_t patterns) {
    ConfusionMatrix matrix(patterns);
    const auto others = static_cast<std::int64_t>(patterns) - 1;
    for (std::size_t i = 0; i < patterns; ++i) {
        for (std::size_t j = 0; j < patterns; ++j)
            matrix.add(i, j, i == j ? 7 * others : 3);
    }
    return matrix;
}

} // namespace teleta::study
