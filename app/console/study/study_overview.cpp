// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_overview.h"

#include <algorithm>

namespace teleta::console {

std::optional<std::size_t> ParticipantOverview::nextSession() const {
    const auto open = std::find_if(sessions.begin(), sessions.end(),
                                   [](const SessionOverview& session) { return !session.isFinished(); });
    return open == sessions.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(open - sessions.begin()));
}

core::Expected<StudyOverview> overviewOf(const study::StudyStore& store) {
    StudyOverview overview{store.folder(), store.head(), {}};
    const auto participants = store.participants();
    if (!participants)
        return core::Unexpected(participants.error());
    for (const study::Participant& participant : *participants) {
        ParticipantOverview one{participant, {}};
        for (study::PlannedSession& plan :
             planSessions(overview.head.protocol, overview.head.seed, participant.enrolment))
            one.sessions.push_back({std::move(plan), std::nullopt, 0});
        const auto sessions = store.sessions(participant);
        if (!sessions)
            return core::Unexpected(sessions.error());
        for (const study::SessionRecord& record : *sessions) {
            SessionOverview& session = one.sessions.at(record.planIndex);
            session.record = record;
            const auto trials = store.trials(record);
            if (!trials)
                return core::Unexpected(trials.error());
            session.kept = static_cast<std::size_t>(
                std::count_if(trials->begin(), trials->end(),
                              [](const study::StoredTrial& trial) { return trial.result.isComplete(); }));
        }
        overview.participants.push_back(std::move(one));
    }
    return overview;
}

core::Expected<OpenedSession> openSession(study::StudyStore& store, const study::Participant& participant,
                                          std::size_t planIndex, const study::PlannedSession& plan,
                                          const QDateTime& now) {
    auto claim = store.claim(participant);
    if (!claim)
        return core::Unexpected(claim.error());
    auto record = store.beginSession(participant, planIndex, plan, now);
    if (!record)
        return core::Unexpected(record.error());
    const auto trials = store.trials(*record);
    if (!trials)
        return core::Unexpected(trials.error());
    OpenedSession opened{
        std::move(*record), {}, std::make_shared<study::ParticipantClaim>(std::move(*claim))};
    for (const study::StoredTrial& trial : *trials)
        opened.kept.push_back(trial.result);
    return opened;
}

} // namespace teleta::console
