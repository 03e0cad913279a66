// SPDX-License-Identifier: GPL-3.0-or-later
// Time of 10 000 planned studies of the paper's design, both tasks, at one number of participants, on all
// cores, compared with drawing the answers of the same participants one by one as a rehearsal does
// (SimulatedParticipant), without its store and session, on one core. And of 1000 planned studies of a
// threshold, compared with finding each level of the same tracks anew.
#include "backend/study/planning/identification_plan.h"
#include "backend/study/planning/threshold_plan.h"
#include "backend/study/session/simulated_participant.h"

#include <QCoreApplication>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace teleta;

constexpr std::size_t kStudies = 10'000;

/// The shares of the paper's tables, and people who differ.
study::StudyTruth paperTruth(const study::Protocol& protocol) {
    study::StudyTruth truth;
    for (const study::StudyTask& task : protocol.tasks) {
        study::TaskTruth own{task.id, 0.5, 0.2, {}};
        for (const std::string& condition : task.conditions) {
            const study::ConfusionMatrix matrix = study::knownMatrix(task, condition);
            study::ConditionTruth shares{condition, 0.5, {}};
            for (std::size_t i = 0; i < task.patterns.size(); ++i)
                shares.patterns.push_back(
                    {task.patterns[i].letter, (static_cast<double>(matrix.count(i, i)) + 0.5) /
                                                  (static_cast<double>(matrix.rowTotal(i)) + 1.0)});
            own.conditions.push_back(std::move(shares));
        }
        truth.tasks.push_back(std::move(own));
    }
    return truth;
}

study::Protocol paper() {
    auto protocol = study::paperProtocol();
    if (!protocol)
        std::abort();
    return *protocol;
}

void planPaper(benchmark::State& state) {
    const study::Protocol protocol = paper();
    const study::StudyTruth truth = paperTruth(protocol);
    const auto participants = static_cast<std::size_t>(state.range(0));
    study::PlanSettings settings{{participants}, kStudies};
    settings.target = 0.9999; // no more studies than these
    double power = 0.0;
    for (auto _ : state) {
        for (const study::StudyTask& task : protocol.tasks) {
            const auto plan = study::IdentificationPlan::make(protocol, truth, task.id + ":condition");
            if (!plan)
                std::abort();
            power = study::planPower(*plan, settings).points[0].power();
        }
    }
    benchmark::DoNotOptimize(power);
    state.counters["trials"] = static_cast<double>(kStudies * participants * protocol.testTrials());
    state.counters["trials_per_s"] = benchmark::Counter(
        static_cast<double>(kStudies * participants * protocol.testTrials() * state.iterations()),
        benchmark::Counter::kIsRate);
}

void answerOneByOne(benchmark::State& state) {
    const study::Protocol protocol = paper();
    const auto participants = static_cast<std::size_t>(state.range(0));
    constexpr std::size_t kFewer = 100; // studies
    std::size_t right = 0;
    for (auto _ : state) {
        for (std::size_t person = 0; person < kFewer * participants; ++person) {
            for (const study::PlannedSession& session : study::planSessions(protocol, 1, person)) {
                const study::StudyTask& task = protocol.tasks[session.task];
                const study::SimulatedParticipant simulated{
                    study::knownMatrix(task, task.conditions[session.condition])};
                for (std::size_t i = 0; i < session.test.size(); ++i) {
                    const study::PlannedTrial trial{study::Phase::test, i + 1, 1, 1, session.test[i]};
                    const auto answer =
                        simulated.answer(session.test[i], study::answerSeed(session.seed, trial));
                    right += answer.response == session.test[i] ? 1 : 0;
                }
            }
        }
    }
    benchmark::DoNotOptimize(right);
    state.counters["trials_per_s"] = benchmark::Counter(
        static_cast<double>(kFewer * participants * protocol.testTrials() * state.iterations()),
        benchmark::Counter::kIsRate);
}

/// A track of tactor-detection, 40 trials, in 1000 studies.
constexpr std::size_t kThresholdStudies = 1000;
constexpr std::size_t kTrackTrials = 40;

study::Protocol detection() {
    auto protocol = study::readNamedProtocol("tactor-detection");
    if (!protocol)
        std::abort();
    return *protocol;
}

void planThreshold(benchmark::State& state) {
    study::StudyTruth truth;
    truth.tasks.push_back({"detection", 0.0, 0.0, {}, study::ThresholdTruth{0.1, 3.5, 0.02, 0.02, 0.15}});
    const auto plan = study::ThresholdPlan::make(detection(), truth, "detection:threshold", {});
    if (!plan)
        std::abort();
    const auto participants = static_cast<std::size_t>(state.range(0));
    study::PlanSettings settings{{participants}, kThresholdStudies};
    settings.mostStudies = kThresholdStudies;
    double power = 0.0;
    for (auto _ : state)
        power = study::planPower(*plan, settings).points[0].power();
    benchmark::DoNotOptimize(power);
    const auto trials = static_cast<double>(kThresholdStudies * participants * kTrackTrials);
    state.counters["trials"] = trials;
    state.counters["trials_per_s"] =
        benchmark::Counter(trials * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// The same tracks with each level found anew from the trials before it, as a session that goes on does.
void tracksAnew(benchmark::State& state) {
    const study::Protocol protocol = detection();
    const study::StudyTask& task = protocol.tasks[0];
    const study::Procedure procedure = study::procedureOf(task.design, task.levels, 1, false);
    constexpr std::size_t kTracks = 12;
    const study::PsychometricFunction observer{study::RiseShape::weibull, 0.1, 3.5, 0.5, 0.02};
    std::size_t right = 0;
    for (auto _ : state) {
        for (std::size_t track = 0; track < kTracks; ++track) {
            core::RandomStream random(track);
            std::vector<study::KeptTrial> kept;
            for (std::size_t trial = 0; trial < kTrackTrials; ++trial) {
                const auto step = study::nextStep(procedure, task.levels.range, track, kept);
                const double level = std::get<study::NextLevel>(step).level;
                kept.push_back({level, 0, random.uniform() < observer.shareAt(level), true});
                right += kept.back().correct ? 1 : 0;
            }
        }
    }
    benchmark::DoNotOptimize(right);
    state.counters["trials_per_s"] = benchmark::Counter(
        static_cast<double>(kTracks * kTrackTrials * state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK(answerOneByOne)->Arg(6)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(planPaper)->Arg(6)->Arg(24)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(tracksAnew)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(planThreshold)->Arg(6)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
