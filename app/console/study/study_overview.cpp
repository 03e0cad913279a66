// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_overview.h"

#include <algorithm>

namespace teleta::console {

namespace {

/// Questionnaires of the whole study come before the participant's first session and after the last one,
/// whichever that is. A session stays open until those after it are answered, so that an interruption loses
/// none.
core::Expected<void> findDue(const study::StudyStore& store, const study::Participant& participant,
                             const study::SessionRecord& record, OpenedSession& opened) {
    const study::Protocol& protocol = store.head().protocol;
    if (protocol.questionnaires.empty())
        return {};
    TELETA_TRY(const auto answers, store.answers(participant));
    TELETA_TRY(const auto sessions, store.sessions(participant));
    const auto finished = std::count_if(sessions.begin(), sessions.end(), [&](const auto& session) {
        return session.finished || session.key == record.key;
    });
    const bool isLast = static_cast<std::size_t>(finished) ==
                        planSessions(protocol, store.head().seed, participant.enrolment).size();
    const auto add = [&](std::vector<study::DueQuestionnaire>& list, study::QuestionnaireTime when) {
        for (study::DueQuestionnaire& due : dueQuestionnaires(protocol, when, record, answers))
            list.push_back(std::move(due));
    };
    add(opened.before, study::QuestionnaireTime::beforeStudy);
    add(opened.before, study::QuestionnaireTime::beforeSession);
    add(opened.after, study::QuestionnaireTime::afterSession);
    if (isLast)
        add(opened.after, study::QuestionnaireTime::afterStudy);
    return {};
}

} // namespace

std::optional<std::size_t> ParticipantOverview::nextSession() const {
    const auto open = std::find_if(sessions.begin(), sessions.end(),
                                   [](const SessionOverview& session) { return !session.isFinished(); });
    return open == sessions.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(open - sessions.begin()));
}

core::Expected<StudyOverview> overviewOf(const study::StudyStore& store) {
    StudyOverview overview{store.location(), store.shownName(), store.head(), {}, store.isReadOnly()};
    const auto participants = store.participants();
    TELETA_CHECK(participants);
    for (const study::Participant& participant : *participants) {
        ParticipantOverview one{participant, {}};
        for (study::PlannedSession& plan :
             planSessions(overview.head.protocol, overview.head.seed, participant.enrolment))
            one.sessions.push_back({std::move(plan), std::nullopt, {}, 0});
        const auto sessions = store.sessions(participant);
        TELETA_CHECK(sessions);
        for (const study::SessionRecord& record : *sessions) {
            SessionOverview& session = one.sessions.at(record.planIndex);
            session.record = record;
            TELETA_TRY(const auto trials, store.trials(record));
            session.results.reserve(trials.size());
            for (const study::StoredTrial& trial : trials)
                session.results.push_back(trial.result);
            session.kept = static_cast<std::size_t>(
                std::count_if(session.results.begin(), session.results.end(),
                              [](const study::TrialResult& result) { return result.isComplete(); }));
        }
        overview.participants.push_back(std::move(one));
    }
    return overview;
}

core::Expected<OpenedSession> openSession(study::StudyStore& store, const study::Participant& participant,
                                          std::size_t planIndex, const study::PlannedSession& plan,
                                          const QDateTime& now) {
    auto claim = store.claim(participant);
    TELETA_CHECK(claim);
    auto record = store.beginSession(participant, planIndex, plan, now);
    TELETA_CHECK(record);
    TELETA_TRY(const auto trials, store.trials(*record));
    OpenedSession opened;
    for (const study::StoredTrial& trial : trials)
        opened.kept.push_back(trial.result);
    TELETA_CHECK(findDue(store, participant, *record, opened));
    opened.record = std::move(*record);
    opened.claim = std::make_shared<study::ParticipantClaim>(std::move(*claim));
    return opened;
}

} // namespace teleta::console
