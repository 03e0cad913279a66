// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/simulated_participant.h"

#include "backend/core/random_stream.h"
#include "backend/study/protocol/trial_order.h"

#include <cmath>
#include <numbers>

namespace teleta::study {

namespace {

/// Streams of a trial.
constexpr std::uint64_t kConfusionSeed = 1;
constexpr std::uint64_t kLapses = 2;
constexpr std::uint64_t kTimeSeed = 3;

using AnswerCounts = std::vector<std::vector<int>>;

ConfusionMatrix matrixOf(const AnswerCounts& counts) {
    ConfusionMatrix matrix(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t j = 0; j < counts[i].size(); ++j)
            matrix.add(i, j, counts[i][j]);
    }
    return matrix;
}

} // namespace

std::uint64_t answerSeed(std::uint64_t sessionSeed, const PlannedTrial& trial) {
    const std::uint64_t part =
        (trial.trial << 16U) + (trial.attempt << 1U) + (trial.phase == Phase::test ? 1 : 0);
    return derivedSeed(derivedSeed(sessionSeed, kSeedOfAnswers), part);
}

SimulatedParticipant::Answer SimulatedParticipant::answer(std::size_t stimulus, std::uint64_t seed) const {
    Answer answer{std::nullopt, time_s(seed)};
    if (!isLapse(seed))
        answer.response = response(stimulus, seed);
    return answer;
}

bool SimulatedParticipant::isLapse(std::uint64_t seed) const {
    return lapses > 0.0 && core::RandomStream(derivedSeed(seed, kLapses)).uniform() < lapses;
}

double SimulatedParticipant::time_s(std::uint64_t seed) const {
    if (logSpread == 0.0)
        return medianResponse_s;
    core::RandomStream random(derivedSeed(seed, kTimeSeed));
    const double radius = std::sqrt(-2.0 * std::log1p(-random.uniform()));
    const double normal = radius * std::cos(2.0 * std::numbers::pi * random.uniform());
    return medianResponse_s * std::exp(logSpread * normal);
}

std::size_t SimulatedParticipant::response(std::size_t stimulus, std::uint64_t seed) const {
    if (!matrix)
        return stimulus;
    const double choice = core::RandomStream(derivedSeed(seed, kConfusionSeed)).uniform();
    const std::int64_t total = matrix->rowTotal(stimulus);
    if (total == 0)
        return static_cast<std::size_t>(choice * static_cast<double>(matrix->patterns()));
    auto left = static_cast<std::int64_t>(choice * static_cast<double>(total));
    std::size_t column = 0;
    // Lapses are drawn elsewhere: the last column (no answer) is left out.
    while (column + 1 < matrix->patterns() && left >= matrix->count(stimulus, column)) {
        left -= matrix->count(stimulus, column);
        ++column;
    }
    return column;
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

ConfusionMatrix knownMatrix(const StudyTask& task, std::string_view condition) {
    const std::optional<ConfusionMatrix> paper = paperMatrix(task.id, condition);
    return paper && paper->patterns() == task.patterns.size() ? *paper : assumedMatrix(task.patterns.size());
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
