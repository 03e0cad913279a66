// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/adaptive/track.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::study {

/// Which intervals of a trial have the level; the others have the reference. Values of the column target.
///   yes_no          0 the reference (a catch trial), 1 the level
///   interval        the interval with the level, from 0
///   compare         the same
///   same_different  0 both the reference, 1 both the level, 2 reference then level, 3 level then reference
using Target = std::size_t;

/// The right answer, an index of answersOf(). compare: the interval that has more; of an equal pair, which
/// has none, that of the level. Thread: any (pure).
[[nodiscard]] std::size_t rightAnswer(Design design, Target target, double level, double reference);

/// Whether a trial moves its track: not catch trials nor those with the same in both intervals.
[[nodiscard]] bool movesTrack(Design design, Target target);

/// Trials that move a track, of one repetition; the most of an adaptive one.
[[nodiscard]] std::size_t mostTrialsOfTrack(const LevelTask& task);

/// All trials of a phase of a session with levels, catch and same trials included; the most with an adaptive
/// procedure. plan: with task and seed. Thread: any (pure).
[[nodiscard]] std::size_t mostTrials(const Protocol& protocol, const PlannedSession& plan, Phase phase);

/// The trials of a session whose task has levels. The next one is a function of the protocol, the session's
/// seed and the results that were kept.
///
/// Practice has `repetitions` trials a track at the practice level. The test has each track as often as
/// `repetitions` says, each with a seed of its own; constant stimuli have one track, with each level as
/// often. Tracks take turns in rounds: each round has every unfinished one once, in random order, and does
/// not begin with the last one of the round before, so that a place on the skin rests. An aborted trial and
/// one with a device fault are shown again at once. Without an answer in time a trial is wrong; in `compare`
/// it says nothing and the track stays where it was. Seeds: of track k of the test
/// derivedSeed(derivedSeed(session, 1), k), of practice (.., 0); what trial i of a track shows
/// derivedSeed(track, i); round r derivedSeed(session, 2 + r), in practice of derivedSeed(session, 0).
/// Thread: one.
class LevelSequence {
public:
    LevelSequence(const Protocol& protocol, const PlannedSession& plan);

    /// Empty: the session is over.
    [[nodiscard]] std::optional<PlannedTrial> next() const;
    /// The result of the trial that next() gave.
    void take(const TrialResult& result);

private:
    /// A track in a phase.
    struct Run {
        std::size_t track = 0;
        std::size_t repetition = 1;
        std::uint64_t seed = 0;
        std::size_t drawn = 0;                ///< trials of it that were completed
        std::vector<KeptTrial> kept = {};     ///< of the test
        std::optional<BayesTrack> bayes = {}; ///< of a Bayesian procedure, as far as it is
        std::optional<NextLevel> level = {};  ///< of the next trial; empty: it is over
    };

    void begin(Phase phase);
    void beginRound();
    void look(Run& run) const;
    [[nodiscard]] Target targetOf(const Run& run) const;
    [[nodiscard]] std::size_t repetitionOf(const Run& run, double level, Target target) const;

    StudyTask m_task;
    double m_reference = 0.0;
    std::uint64_t m_seed = 0;
    std::size_t m_practice = 0; ///< trials a track
    std::size_t m_tests = 0;    ///< runs of each track
    Procedure m_procedure;
    std::shared_ptr<const BayesGrid> m_grid; ///< shared by copies and tracks

    Phase m_phase = Phase::practice;
    std::vector<Run> m_runs;
    std::vector<std::size_t> m_round; ///< indices of m_runs
    std::size_t m_turn = 0;           ///< in m_round
    std::size_t m_rounds = 0;         ///< begun
    std::optional<std::size_t> m_last;
    std::size_t m_trial = 1;
    std::size_t m_attempt = 1;
    bool m_over = false;
};

} // namespace teleta::study
