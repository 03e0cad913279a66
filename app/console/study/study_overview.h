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

/// A session of a participant's plan, and its progress.
struct SessionOverview {
    study::PlannedSession plan;
    std::optional<study::SessionRecord> record; ///< empty: not begun
    std::vector<study::TrialResult> results;    ///< that were kept
    std::size_t kept = 0;                       ///< of them complete
    [[nodiscard]] std::size_t planned() const { return plan.practiceTrials + plan.testTrials; }
    [[nodiscard]] bool isFinished() const { return record && record->finished; }
    [[nodiscard]] bool isInterrupted() const { return record && !record->finished; }
};

struct ParticipantOverview {
    study::Participant participant;
    std::vector<SessionOverview> sessions;
    /// The first unfinished session; empty: all are finished.
    [[nodiscard]] std::optional<std::size_t> nextSession() const;
};

/// The contents of a study at one time.
struct StudyOverview {
    study::StoreLocation location;
    std::string store; ///< the file, or the server without any password
    study::StudyHead head;
    std::vector<ParticipantOverview> participants;
    bool isReadOnly = false; ///< opened for reading
};

/// Thread: that of the store. Error: what the store reports.
[[nodiscard]] core::Expected<StudyOverview> overviewOf(const study::StudyStore& store);

/// What is needed to run a session.
struct OpenedSession {
    study::SessionRecord record;
    std::vector<study::TrialResult> kept;
    std::vector<study::DueQuestionnaire> before;    ///< the first trial
    std::vector<study::DueQuestionnaire> after;     ///< the last one
    std::shared_ptr<study::ParticipantClaim> claim; ///< keeps others from running the participant
};

/// Starts or resumes a session of the participant's plan. Error: refused when somebody else runs the
/// participant; what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<OpenedSession>
openSession(study::StudyStore& store, const study::Participant& participant, std::size_t planIndex,
            const study::PlannedSession& plan, const QDateTime& now);

} // namespace teleta::console
