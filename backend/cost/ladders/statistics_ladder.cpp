// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/study/analysis/study_transfer.h"
#include "backend/study/analysis/transfer_interval.h"
#include "backend/study/session/simulated_participant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

namespace teleta::cost {

namespace {

constexpr std::size_t kStudies = 40;
constexpr std::size_t kPeople = 10;
constexpr int kPresentations = 3;

struct SimulatedStudy {
    std::vector<study::ConfusionMatrix> people;
    study::ConfusionMatrix pooled{1};
};

/// The paper's number of people and trials, answering as the paper's participants did with static shapes.
SimulatedStudy simulateStudy(std::size_t number, const study::ConfusionMatrix& truth) {
    study::SimulatedParticipant person;
    person.matrix = truth;
    constexpr std::uint64_t kSeedsOfAStudy = 10'000;
    std::uint64_t seed = number * kSeedsOfAStudy;
    SimulatedStudy made{{}, study::ConfusionMatrix(truth.patterns())};
    for (std::size_t i = 0; i < kPeople; ++i) {
        study::ConfusionMatrix answers(truth.patterns());
        for (std::size_t pattern = 0; pattern < truth.patterns(); ++pattern)
            for (int k = 0; k < kPresentations; ++k)
                answers.add(pattern, person.answer(pattern, ++seed).response);
        made.pooled.add(answers);
        made.people.push_back(std::move(answers));
    }
    return made;
}

/// Of a person who answers with these shares and all patterns shown equally often:
///   sum_ij p_ij / k log2(p_ij / mean_i p_ij)
double trueTransfer_bit(const study::ConfusionMatrix& truth) {
    const std::size_t k = truth.patterns();
    const auto share = [&](std::size_t i, std::size_t j) {
        return static_cast<double>(truth.count(i, j)) / static_cast<double>(truth.rowTotal(i));
    };
    double transfer_bit = 0.0;
    for (std::size_t j = 0; j < k; ++j) {
        double answered = 0.0;
        for (std::size_t i = 0; i < k; ++i)
            answered += share(i, j) / static_cast<double>(k);
        for (std::size_t i = 0; i < k; ++i)
            if (share(i, j) > 0.0)
                transfer_bit += share(i, j) / static_cast<double>(k) * std::log2(share(i, j) / answered);
    }
    return transfer_bit;
}

/// Interval score of a 95 % interval: its width, and 2 / 0.05 times how far the truth is outside. Source:
/// Gneiting and Raftery 2007, doi:10.1198/016214506000001437, eq. (43).
double intervalScore(const study::Interval& interval, double truth) {
    constexpr double kPenalty = 2.0 / 0.05;
    return interval.high - interval.low +
           kPenalty * (std::max(0.0, interval.low - truth) + std::max(0.0, truth - interval.high));
}

struct StudyInput {
    std::vector<SimulatedStudy> studies;
    double transfer_bit = 0.0;
};

Rung intervalRung(std::string name, std::string parameter, std::size_t calls,
                  const std::shared_ptr<const StudyInput>& input,
                  const std::function<std::optional<study::Interval>(const SimulatedStudy&)>& intervalOf) {
    return {std::move(name), std::move(parameter), [=](Trial& trial) {
                const SimulatedStudy& one = input->studies[trial.index() % input->studies.size()];
                std::optional<study::Interval> interval;
                trial.timed(calls, [&] {
                    for (std::size_t i = 0; i < calls; ++i)
                        interval = intervalOf(one);
                });
                trial.error(intervalScore(interval.value(), input->transfer_bit));
            }};
}

} // namespace

Ladder statisticsLadder() {
    Ladder ladder;
    ladder.name = "statistics";
    ladder.topic = Topic::study;
    ladder.title = LadderText::tr("Interval of the information transfer of a study").toStdString();
    ladder.truth =
        LadderText::tr("score of the 95 % interval: its width, and 40 times how far the true transfer lies "
                       "outside of it")
            .toStdString();
    ladder.errorUnit = "bit";
    ladder.trials = kStudies;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const study::ConfusionMatrix truth = study::paperMatrix("shape", "static").value();
        auto made = std::make_shared<StudyInput>();
        made->transfer_bit = trueTransfer_bit(truth);
        for (std::size_t i = 0; i < kStudies; ++i)
            made->studies.push_back(simulateStudy(i, truth));
        const std::shared_ptr<const StudyInput> input = made;
        constexpr std::size_t kShortCalls = 16;
        const auto asymptotic = [&](const char* name, const char* parameter, study::TransferBias bias) {
            return intervalRung(name, parameter, kShortCalls, input, [=](const SimulatedStudy& one) {
                return study::asymptoticTransfer(one.pooled, bias);
            });
        };
        std::vector<Rung> rungs{
            asymptotic("asymptotic", "bias left in", study::TransferBias::none),
            asymptotic("asymptotic-miller", "Miller's bias", study::TransferBias::miller),
            asymptotic("asymptotic-occupied", "Miller's bias over occupied cells",
                       study::TransferBias::occupied),
            asymptotic("asymptotic-jackknife", "jackknife over trials", study::TransferBias::jackknife),
            asymptotic("asymptotic-grassberger", "Grassberger's entropies", study::TransferBias::grassberger),
            intervalRung("jackknife-participants", "jackknife over participants, Student's t", kShortCalls,
                         input, [](const SimulatedStudy& one) {
                             const auto transfer = study::studyTransfer(one.people);
                             return transfer ? transfer->interval : std::nullopt;
                         })};
        const auto bootstrap = [&](const char* name, std::size_t resamples, const char* remark,
                                   const auto& transferOf) {
            constexpr std::uint64_t kSeed = 1;
            constexpr double kConfidence = 0.95;
            const std::string count = std::to_string(resamples);
            return intervalRung(name + count, count + " resamples" + remark, 1, input,
                                [=](const SimulatedStudy& one) {
                                    return transferOf(one.people, resamples, kSeed, kConfidence);
                                });
        };
        for (const std::size_t resamples : {100U, 1000U, 10'000U, 100'000U})
            rungs.push_back(bootstrap("bootstrap-", resamples, "", study::bootstrapTransfer));
        for (const std::size_t resamples : {100U, 1000U, 10'000U})
            rungs.push_back(bootstrap("bootstrap-miller-", resamples, ", Miller's bias",
                                      study::correctedBootstrapTransfer));
        constexpr std::size_t kCalls = 256;
        rungs.push_back(
            limitRung("each cell of the pooled matrix added up once", kCalls, [=](std::size_t index) {
                const study::ConfusionMatrix& pooled = input->studies[index % input->studies.size()].pooled;
                std::int64_t sum = 0;
                for (std::size_t row = 0; row < pooled.patterns(); ++row)
                    for (std::size_t column = 0; column < pooled.columns(); ++column)
                        sum += pooled.count(row, column);
                return static_cast<double>(sum);
            }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
