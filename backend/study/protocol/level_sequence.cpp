// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/level_sequence.h"

#include "backend/core/random_stream.h"
#include "backend/study/protocol/trial_order.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace teleta::study {

namespace {

/// The first part of a session's seed that orders a round.
constexpr std::uint64_t kSeedOfRounds = 2;
/// In how fine steps the share of catch trials counts.
constexpr std::uint64_t kCatchSteps = 1'000'000;

Target drawTarget(Design design, const LevelTask& task, std::uint64_t seed) {
    core::RandomStream random(seed);
    switch (design) {
    case Design::yesNo:
        return static_cast<double>(random.below(kCatchSteps)) <
                       std::round(task.catchShare * static_cast<double>(kCatchSteps))
                   ? 0
                   : 1;
    case Design::sameDifferent:
        return static_cast<Target>(random.below(4));
    case Design::interval:
    case Design::compare:
    case Design::identification:
        break;
    }
    return static_cast<Target>(random.below(intervalsOf(design, task)));
}

std::uint64_t seedOfTrack(std::uint64_t session, Phase phase, std::size_t track) {
    return derivedSeed(derivedSeed(session, phase == Phase::practice ? kSeedOfPractice : kSeedOfTest), track);
}

/// What speaks for a lower threshold: a right answer, "yes", "different", "the level has more".
bool speaksForLower(Design design, Target target, const TrialResult& result) {
    switch (design) {
    case Design::yesNo:
        return result.response == 0U;
    case Design::sameDifferent:
        return result.response == 1U;
    case Design::interval:
    case Design::compare:
    case Design::identification:
        break;
    }
    return result.response == target;
}

} // namespace

std::size_t rightAnswer(Design design, Target target, double level, double reference) {
    switch (design) {
    case Design::yesNo:
        return target == 1 ? 0 : 1;
    case Design::sameDifferent:
        return target < 2 ? 0 : 1;
    case Design::compare:
        return level >= reference ? target : 1 - target;
    case Design::interval:
    case Design::identification:
        break;
    }
    return target;
}

bool movesTrack(Design design, Target target) {
    return design == Design::yesNo ? target == 1 : design != Design::sameDifferent || target >= 2;
}

std::size_t mostTrialsOfTrack(const LevelTask& task) {
    if (const auto* staircase = std::get_if<StaircaseSettings>(&task.procedure))
        return staircase->mostTrials;
    if (const auto* bayes = std::get_if<BayesSettings>(&task.procedure))
        return bayes->mostTrials;
    return task.values.size();
}

std::size_t mostTrials(const Protocol& protocol, const PlannedSession& plan, Phase phase) {
    const StudyTask& task = protocol.tasks[plan.task];
    const LevelTask& levels = task.levels;
    if (phase == Phase::practice)
        return levels.tracks.size() * protocol.practice.repetitions;
    const bool constant = std::holds_alternative<ConstantSettings>(levels.procedure);
    const std::size_t runs = levels.tracks.size() * (constant ? 1 : protocol.test.repetitions);
    const std::size_t wanted = mostTrialsOfTrack(levels) * (constant ? protocol.test.repetitions : 1);
    if (task.design != Design::sameDifferent && levels.catchShare == 0.0)
        return runs * wanted;
    std::size_t trials = 0;
    for (std::size_t run = 0; run < runs; ++run) {
        const std::uint64_t seed = seedOfTrack(plan.seed, phase, run);
        std::size_t moves = 0;
        for (std::size_t i = 0; moves < wanted; ++i) {
            moves += movesTrack(task.design, drawTarget(task.design, levels, derivedSeed(seed, i))) ? 1 : 0;
            ++trials;
        }
    }
    return trials;
}

LevelSequence::LevelSequence(const Protocol& protocol, const PlannedSession& plan)
    : m_task(protocol.tasks[plan.task])
    , m_reference(m_task.referenceOf(m_task.conditions[plan.condition]))
    , m_seed(plan.seed)
    , m_practice(protocol.practice.repetitions)
    , m_tests(std::holds_alternative<ConstantSettings>(m_task.levels.procedure)
                  ? std::min<std::size_t>(protocol.test.repetitions, 1)
                  : protocol.test.repetitions)
    , m_procedure(procedureOf(m_task.design, m_task.levels, protocol.test.repetitions,
                              protocol.order == OrderMethod::blockedRandom)) {
    if (const auto* bayes = std::get_if<BayesSettings>(&m_procedure))
        m_grid = std::make_shared<const BayesGrid>(*bayes, m_task.levels.range);
    begin(Phase::practice);
}

void LevelSequence::begin(Phase phase) {
    m_phase = phase;
    m_trial = 1;
    m_rounds = 0;
    m_last.reset();
    m_runs.clear();
    const std::size_t repetitions = phase == Phase::practice ? std::min<std::size_t>(m_practice, 1) : m_tests;
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
        for (std::size_t track = 0; track < m_task.levels.tracks.size(); ++track) {
            Run run{track, repetition + 1, seedOfTrack(m_seed, phase, m_runs.size())};
            if (m_grid && phase == Phase::test)
                run.bayes.emplace(*m_grid);
            look(run);
            m_runs.push_back(std::move(run));
        }
    }
    beginRound();
}

/// Finds the level of the run's next trial.
void LevelSequence::look(Run& run) const {
    run.level.reset();
    if (m_phase == Phase::practice) {
        if (run.drawn < m_practice)
            run.level = NextLevel{m_task.levels.practiceLevel.value_or(m_task.levels.range.highest)};
        return;
    }
    const TrackStep step =
        run.bayes ? run.bayes->next() : nextStep(m_procedure, m_task.levels.range, run.seed, run.kept);
    if (const auto* level = std::get_if<NextLevel>(&step))
        run.level = *level;
}

void LevelSequence::beginRound() {
    m_round.clear();
    m_turn = 0;
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
        if (m_runs[i].level)
            m_round.push_back(i);
    }
    if (m_round.empty()) {
        if (m_phase == Phase::practice)
            begin(Phase::test);
        else
            m_over = true;
        return;
    }
    const std::uint64_t seed = m_phase == Phase::practice ? derivedSeed(m_seed, kSeedOfPractice) : m_seed;
    core::RandomStream random(derivedSeed(seed, kSeedOfRounds + m_rounds));
    random.shuffle(std::span<std::size_t>(m_round));
    if (m_round.size() > 1 && m_last == m_round.front())
        std::swap(m_round[0], m_round[1]);
    ++m_rounds;
}

Target LevelSequence::targetOf(const Run& run) const {
    return drawTarget(m_task.design, m_task.levels, derivedSeed(run.seed, run.drawn));
}

/// Of constant stimuli: how often this level comes in its track; otherwise that of the track.
std::size_t LevelSequence::repetitionOf(const Run& run, double level, Target target) const {
    if (m_phase == Phase::practice)
        return run.drawn + 1;
    if (!std::holds_alternative<ConstantSettings>(m_procedure))
        return run.repetition;
    const bool counts = movesTrack(m_task.design, target);
    return 1 + static_cast<std::size_t>(std::ranges::count_if(run.kept, [&](const KeptTrial& trial) {
               return trial.counts == counts && (!counts || trial.level == level);
           }));
}

std::optional<PlannedTrial> LevelSequence::next() const {
    if (m_over)
        return std::nullopt;
    const Run& run = m_runs[m_round[m_turn]];
    const Target target = targetOf(run);
    PlannedTrial trial;
    trial.phase = m_phase;
    trial.trial = m_trial;
    trial.attempt = m_attempt;
    trial.track = m_task.levels.tracks[run.track].id;
    trial.target = target;
    // A catch trial has the reference and nothing else.
    const bool isCatch = m_task.design == Design::yesNo && target == 0;
    trial.level = isCatch ? m_reference : run.level->level;
    trial.repetition = repetitionOf(run, *trial.level, target);
    trial.stimulus = rightAnswer(m_task.design, target, *trial.level, m_reference);
    return trial;
}

void LevelSequence::take(const TrialResult& result) {
    if (m_over)
        return;
    if (!result.isComplete()) {
        ++m_attempt;
        return;
    }
    Run& run = m_runs[m_round[m_turn]];
    const Target target = targetOf(run);
    const bool isSilent = m_task.design == Design::compare && !result.response;
    const KeptTrial kept{result.planned.level.value_or(0.0), result.response.value_or(0),
                         speaksForLower(m_task.design, target, result),
                         movesTrack(m_task.design, target) && !isSilent};
    if (m_phase == Phase::test)
        run.kept.push_back(kept);
    if (run.bayes && kept.counts)
        run.bayes->add(kept.level, kept.correct);
    ++run.drawn;
    look(run);
    m_last = m_round[m_turn];
    ++m_trial;
    m_attempt = 1;
    if (++m_turn == m_round.size())
        beginRound();
}

} // namespace teleta::study
