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
    std::size_t participants = 0; ///< with all their sessions
    std::size_t trials = 0;       ///< kept in this run
    std::size_t trialsBefore = 0; ///< kept before it
    double simulated_s = 0.0;     ///< in the sessions of this run
    bool interrupted = false;
};

/// Who takes part in a rehearsal, where it is not the participants of the paper with the study's lapses and
/// a bracelet that never fails.
struct RehearsalCast {
    struct Shown {
        double latency_s = 0.005;                ///< from the request to the onset
        std::optional<std::size_t> framesMissed; ///< empty: nobody counted
    };

    /// seed: of the trial; the answer depends on the arguments alone. Empty: as above.
    std::function<SimulatedParticipant::Answer(const StudyTask& task, const std::string& condition,
                                               std::size_t stimulus, std::uint64_t seed)>
        answer;
    /// pattern: its id. Empty: as above.
    std::function<Shown(const std::string& pattern, std::uint64_t seed)> show;
    /// Asked before each trial with the time that was simulated in this run; false stops.
    std::function<bool(double simulated_s)> goOn;
};

/// Practice and test trials that all planned participants of a rehearsal go through. Thread: any.
[[nodiscard]] std::size_t plannedTrials(const StudyHead& head);

/// Lets simulated participants P01, P02 .. go through all sessions of a study that is still to be done, with
/// the session code of real ones and a clock of its own, as fast as the store keeps the trials. Every answer
/// depends on the seed and the trial alone: a rehearsal that was interrupted and goes on has the same trials
/// as one that was not, and so are its times of day, which count from the creation of the study.
/// Each finished session is exported as Psych-DS.
/// Questionnaires are answered by chance. goOn: asked before each trial; false stops. Error: refused unless
/// the study is simulated; what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<RehearsalProgress> rehearse(StudyStore& store,
                                                         const std::function<bool(std::size_t trials)>& goOn,
                                                         const RehearsalCast& cast = {});

} // namespace teleta::study
