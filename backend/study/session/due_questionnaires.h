// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_store.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::study {

/// A questionnaire to be filled in now.
struct DueQuestionnaire {
    std::size_t index = 0;                ///< in Protocol::questionnaires
    std::optional<SessionRecord> session; ///< that it belongs to; empty: to the participant as a whole
};

/// Questionnaires for this time that have no answers yet, in the protocol's order. session: only used for
/// times that belong to a session. answers: all answers of the participant. Thread: any (pure).
[[nodiscard]] std::vector<DueQuestionnaire> dueQuestionnaires(const Protocol& protocol,
                                                              QuestionnaireTime when,
                                                              const SessionRecord& session,
                                                              const std::vector<StoredAnswer>& answers);

/// A questionnaire as a participant sees it: pairs in an order that depends on the study's seed, the
/// participant, the session if there is one, and the questionnaire alone. plan: as in simulatedAnswers().
/// Thread: any (pure).
[[nodiscard]] Questionnaire shownQuestionnaire(const StudyHead& head, const Participant& participant,
                                               const PlannedSession& plan, std::size_t index);

/// Answers of a simulated participant: random points and choices, and "simulated" as text. They depend on the
/// study's seed, the participant, the session if there is one, and the questionnaire alone. plan: of the
/// session; only used for questionnaires that belong to one. Thread: any (pure).
[[nodiscard]] std::vector<ItemAnswer> simulatedAnswers(const StudyHead& head, const Participant& participant,
                                                       const PlannedSession& plan, std::size_t index);

} // namespace teleta::study
