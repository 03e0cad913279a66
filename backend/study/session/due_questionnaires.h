// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_store.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::study {

/// A questionnaire that is to be filled in now.
struct DueQuestionnaire {
    std::size_t index = 0;                ///< in Protocol::questionnaires
    std::optional<SessionRecord> session; ///< that it belongs to; empty: to the participant as a whole
};

/// Those of a time that have no answers yet, in the protocol's order. session: taken into account where the
/// time is one of a session. answers: all of the participant. Thread: any (pure).
[[nodiscard]] std::vector<DueQuestionnaire> dueQuestionnaires(const Protocol& protocol,
                                                              QuestionnaireTime when,
                                                              const SessionRecord& session,
                                                              const std::vector<StoredAnswer>& answers);

/// What a simulated participant says: any point or choice, and that it is simulated. It depends on the
/// study's seed, the participant, the session where there is one, and the questionnaire alone.
/// plan: of the session; looked at where the questionnaire belongs to one. Thread: any (pure).
[[nodiscard]] std::vector<ItemAnswer> simulatedAnswers(const StudyHead& head, const Participant& participant,
                                                       const PlannedSession& plan, std::size_t index);

} // namespace teleta::study
