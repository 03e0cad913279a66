// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/session/due_questionnaires.h"
#include "backend/study/store/study_store.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::console {

/// One session of a participant's plan, and how far it is.
struct SessionOverview {
    study::PlannedSession plan;
    std::optional<study::SessionRecord> record; ///< empty: not begun
    std::vector<study::TrialResult> results;    ///< that were kept
    std::size_t kept = 0;                       ///< of them complete
    [[nodiscard]] std::size_t planned() const { return plan.practice.size() + plan.test.size(); }
    [[nodiscard]] bool isFinished() const { return record && record->finished; }
    [[nodiscard]] bool isInterrupted() const { return record && !record->finished; }
};

struct ParticipantOverview {
    study::Participant participant;
    std::vector<SessionOverview> sessions;
    /// The first one that is not finished; empty when all are.
    [[nodiscard]] std::optional<std::size_t> nextSession() const;
};

/// What a study has, at one time.
struct StudyOverview {
    study::StoreLocation location;
    std::string store; ///< the file, or the server without any password
    study::StudyHead head;
    std::vector<ParticipantOverview> participants;
    bool isReadOnly = false; ///< it can only be looked at
};

/// Thread: that of the store. Error: what the store reports.
[[nodiscard]] core::Expected<StudyOverview> overviewOf(const study::StudyStore& store);

/// What is needed to go on with a session.
struct OpenedSession {
    study::SessionRecord record;
    std::vector<study::TrialResult> kept;
    std::vector<study::DueQuestionnaire> before;    ///< the first trial
    std::vector<study::DueQuestionnaire> after;     ///< the last one
    std::shared_ptr<study::ParticipantClaim> claim; ///< nobody else runs the participant as long as it lives
};

/// Begins the session of a place in the participant's plan, or goes on with it. Error: refused when somebody
/// else runs the participant; what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<OpenedSession>
openSession(study::StudyStore& store, const study::Participant& participant, std::size_t planIndex,
            const study::PlannedSession& plan, const QDateTime& now);

} // namespace teleta::console
