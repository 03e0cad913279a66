// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/session/simulated_participant.h"
#include "backend/study/store/study_store.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace teleta::study {

struct RehearsalProgress {
    std::size_t participants = 0; ///< those who have finished all their sessions
    std::size_t trials = 0;       ///< kept in this run
    std::size_t trialsBefore = 0; ///< kept before it
    double simulated_s = 0.0;     ///< in the sessions of this run
    bool interrupted = false;
    [[nodiscard]] std::size_t allTrials() const { return trialsBefore + trials; }
};

/// Replaces parts of a rehearsal. Without it participants answer as in the paper, in tasks with levels as the
/// study's observer does, with the study's lapses, and the bracelet never fails.
struct RehearsalCast {
    struct Shown {
        double latency_s = 0.005;                ///< from the request to the onset
        std::optional<std::size_t> framesMissed; ///< empty: not counted
    };

    /// seed: answerSeed() of the trial; the answer must depend on the arguments alone. Empty: as above.
    std::function<SimulatedParticipant::Answer(const StudyTask& task, const std::string& condition,
                                               std::size_t stimulus, std::uint64_t seed)>
        answer = {};
    /// The same for tasks with levels. person: observerSeed() of the participant.
    std::function<SimulatedParticipant::Answer(const StudyTask& task, const std::string& condition,
                                               const PlannedTrial& trial, std::uint64_t person,
                                               std::uint64_t seed)>
        observe = {};
    /// pattern: null if the protocol has none; it is cut off at atMost_s. Empty: as above.
    std::function<Shown(const pattern::Pattern* pattern, double atMost_s, std::uint64_t seed)> show = {};
    /// Asked before each trial; false interrupts the rehearsal. Empty: nothing does.
    std::function<bool(const RehearsalProgress& now)> goOn = {};
};

/// Practice and test trials of all planned participants of a rehearsal; of adaptive procedures the most.
/// Thread: any.
[[nodiscard]] std::size_t plannedTrials(const StudyHead& head);

/// Runs all sessions of a study that are not finished yet, with simulated participants P01, P02 .., by the
/// same rules as sessions with people (SessionFlow), with a clock of its own, as fast as the store keeps the
/// trials. Every answer depends on the seed and the trial alone, and times of day count from the creation of
/// the study: a rehearsal that was interrupted and resumed has the same trials as an uninterrupted one.
/// Questionnaires are answered at random. Each finished session is exported as Psych-DS. Error: refused
/// unless the study is simulated; what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<RehearsalProgress> rehearse(StudyStore& store, const RehearsalCast& cast = {});

} // namespace teleta::study
