// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/store_values.h"
#include "backend/study/store/study_store.h"
#include "backend/study/store/trial_journal.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

struct TrialsText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

/// The stored form of a questionnaire's answers.
enum class KeptAnswers { none, same, other };

KeptAnswers compare(const std::vector<StoredAnswer>& all, const std::optional<SessionRecord>& session,
                    const std::string& questionnaire, const std::vector<ItemAnswer>& answers) {
    std::size_t kept = 0;
    std::size_t same = 0;
    for (const StoredAnswer& stored : all) {
        if (stored.questionnaire != questionnaire || stored.session.has_value() != session.has_value() ||
            (session && *stored.session != session->key))
            continue;
        ++kept;
        same += static_cast<std::size_t>(
            std::count_if(answers.begin(), answers.end(), [&](const ItemAnswer& answer) {
                return answer.item == stored.item &&
                       answer.value.value_or(std::string()) == stored.value.value_or(std::string());
            }));
    }
    if (kept == 0)
        return KeptAnswers::none;
    return same == kept && kept == answers.size() ? KeptAnswers::same : KeptAnswers::other;
}

bool isSameTrial(const PlannedTrial& a, const PlannedTrial& b) {
    return a.phase == b.phase && a.trial == b.trial && a.attempt == b.attempt;
}

} // namespace

core::Expected<void> StudyStore::insertTrial(long long session, const StoredTrial& trial) {
    const TrialResult& result = trial.result;
    const auto kept = m_connection->run(
        QStringLiteral(
            "INSERT INTO trial (session, phase, trial, attempt, trial_in_block, repetition, stimulus, "
            "response, outcome, response_time_s, response_time_offset_s, response_device, response_key, "
            "n_replays, early_presses, onset_s, duration_s, device_latency_ms, device_faults, time_utc, "
            "frame_write_ms, frames_missed) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        {session,
         QString::fromLatin1(toString(result.planned.phase)),
         number(result.planned.trial),
         number(result.planned.attempt),
         number(result.trialInBlock),
         number(result.planned.repetition),
         number(result.planned.stimulus),
         orNull(result.response),
         QString::fromLatin1(toString(result.outcome)),
         orNull(result.responseTime_s),
         orNull(result.responseTimeOffset_s),
         orNull(result.responseDevice),
         orNull(result.responseKey),
         number(result.replays),
         number(result.earlyPresses),
         result.onset_s,
         result.duration_s,
         orNull(result.deviceLatency_ms),
         number(result.deviceFaults),
         timeText(trial.time),
         orNull(result.frameWrite_ms),
         orNull(result.framesMissed)});
    if (!kept && kept.error().kind == core::ErrorKind::refused)
        return m_connection->refused(TrialsText::tr("this trial is already stored"),
                                     TrialsText::tr("each attempt of a trial once"));
    TELETA_CHECK(kept);
    return {};
}

core::Expected<void> StudyStore::keepTrial(const SessionRecord& session, const TrialResult& result,
                                           const QDateTime& ended) {
    const StoredTrial trial{result, ended};
    return m_connection->isServer() ? keepOnServer(session, trial) : insertTrial(session.key, trial);
}

/// A server that is lost during a commit does not tell whether it has the trial. Onset and answer identify
/// it; the UTC is that of the first attempt.
core::Expected<void> StudyStore::insertUnlessKept(long long session, const StoredTrial& trial) {
    core::Expected<void> kept = insertTrial(session, trial);
    if (kept || kept.error().kind != core::ErrorKind::refused)
        return kept;
    const TrialResult& result = trial.result;
    auto query = m_connection->run(
        QStringLiteral("SELECT outcome, response, response_time_s, stimulus, onset_s, duration_s FROM trial "
                       "WHERE session = ? AND phase = ? AND trial = ? AND attempt = ?"),
        {session, QString::fromLatin1(toString(result.planned.phase)), number(result.planned.trial),
         number(result.planned.attempt)});
    TELETA_CHECK(query);
    const bool isSame =
        query->next() && query->value(0).toString() == QLatin1String(toString(result.outcome)) &&
        query->value(1).isNull() == !result.response &&
        count(query->value(1)) == result.response.value_or(0) &&
        optionalNumber(query->value(2)) == result.responseTime_s &&
        count(query->value(3)) == result.planned.stimulus && query->value(4).toDouble() == result.onset_s &&
        query->value(5).toDouble() == result.duration_s;
    return isSame ? core::Expected<void>() : kept;
}

core::Expected<void> StudyStore::sendPending(long long session) {
    const TrialJournal journal(folder(), session);
    TELETA_TRY(const std::vector<PendingTrial> pending, journal.read());
    if (pending.empty())
        return journal.remove();
    auto query = m_connection->run(QStringLiteral("SELECT id FROM session WHERE key = ?"), {session});
    TELETA_CHECK(query);
    const std::string id = query->next() ? query->value(0).toString().toStdString() : std::string();
    for (const PendingTrial& trial : pending) {
        if (trial.sessionKey != session || trial.sessionId != id)
            return core::Unexpected(
                core::Error{core::ErrorKind::badInput,
                            TrialsText::tr("these trials belong to another study").toStdString(),
                            TrialsText::tr("a separate folder for each study").toStdString(),
                            {journal.path()}});
        if (const core::Expected<void> sent = insertUnlessKept(session, {trial.result, trial.time}); !sent)
            return sent;
    }
    return journal.remove();
}

core::Expected<void> StudyStore::keepOnServer(const SessionRecord& session, const StoredTrial& trial) {
    const std::size_t reconnections = m_connection->reconnections();
    core::Expected<void> kept = sendPending(session.key);
    if (kept) {
        kept = insertTrial(session.key, trial);
        // The last one sent may have been this one.
        const bool isUnsure = m_unsure || m_connection->reconnections() != reconnections;
        if (!kept && kept.error().kind == core::ErrorKind::refused && isUnsure)
            kept = insertUnlessKept(session.key, trial);
    }
    const bool isAway = !kept && kept.error().kind == core::ErrorKind::unavailable;
    // Another error, between two attempts, does not tell either.
    m_unsure = isAway || (m_unsure && !kept);
    if (!isAway)
        return kept;
    const TrialJournal journal(folder(), session.key);
    TELETA_TRY(const std::vector<PendingTrial> pending, journal.read());
    const bool isPending = std::any_of(pending.begin(), pending.end(), [&](const PendingTrial& other) {
        return isSameTrial(other.result.planned, trial.result.planned);
    });
    if (!isPending) {
        const core::Expected<void> safe = journal.append({session.key, session.id, trial.result, trial.time});
        if (!safe)
            return safe;
    }
    core::Error error = kept.error();
    error.message += ' ' + TrialsText::tr("The trial is safe in %1 and will be sent when the server is back.")
                               .arg(QString::fromStdString(journal.path()))
                               .toStdString();
    return core::Unexpected(std::move(error));
}

core::Expected<std::vector<StoredTrial>> StudyStore::trials(const SessionRecord& session) const {
    auto query = m_connection->run(
        QStringLiteral(
            "SELECT phase, trial, attempt, trial_in_block, repetition, stimulus, response, outcome, "
            "response_time_s, response_time_offset_s, response_device, response_key, n_replays, "
            "early_presses, onset_s, duration_s, device_latency_ms, device_faults, time_utc, "
            "frame_write_ms, frames_missed FROM trial "
            "WHERE session = ? ORDER BY key"),
        {session.key});
    TELETA_CHECK(query);
    // The tasks come in the same order for everybody.
    const std::vector<PlannedSession> plan = planSessions(m_head.protocol, m_head.seed, 0);
    if (session.planIndex >= plan.size())
        return m_connection->damaged();
    const std::size_t patterns = m_head.protocol.tasks[plan[session.planIndex].task].patterns.size();
    std::vector<StoredTrial> all;
    while (query->next()) {
        const auto text = [&](int column) { return query->value(column).toString().toStdString(); };
        StoredTrial trial;
        TrialResult& result = trial.result;
        result.planned = {phaseOf(text(0)).value_or(Phase::test), count(query->value(1)),
                          count(query->value(4)), count(query->value(2)), count(query->value(5))};
        result.trialInBlock = count(query->value(3));
        if (!query->value(6).isNull())
            result.response = count(query->value(6));
        if (result.planned.stimulus >= patterns || result.response.value_or(0) >= patterns)
            return m_connection->damaged();
        result.outcome = outcomeOf(text(7)).value_or(Outcome::aborted);
        result.responseTime_s = optionalNumber(query->value(8));
        result.responseTimeOffset_s = optionalNumber(query->value(9));
        result.responseDevice = text(10);
        result.responseKey = text(11);
        result.replays = count(query->value(12));
        result.earlyPresses = count(query->value(13));
        result.onset_s = query->value(14).toDouble();
        result.duration_s = query->value(15).toDouble();
        result.deviceLatency_ms = optionalNumber(query->value(16));
        result.deviceFaults = count(query->value(17));
        trial.time = timeOf(query->value(18).toString());
        result.frameWrite_ms = optionalNumber(query->value(19));
        if (!query->value(20).isNull())
            result.framesMissed = count(query->value(20));
        all.push_back(std::move(trial));
    }
    return all;
}

core::Expected<void> StudyStore::keepNote(const SessionRecord& session, const std::string& text,
                                          const QDateTime& now) {
    const auto kept =
        m_connection->run(QStringLiteral("INSERT INTO note (session, text, time_utc) VALUES (?, ?, ?)"),
                          {session.key, QString::fromStdString(text), timeText(now)});
    TELETA_CHECK(kept);
    return {};
}

core::Expected<std::vector<StoredNote>> StudyStore::notes(const SessionRecord& session) const {
    auto query = m_connection->run(
        QStringLiteral("SELECT text, time_utc FROM note WHERE session = ? ORDER BY key"), {session.key});
    TELETA_CHECK(query);
    std::vector<StoredNote> all;
    while (query->next())
        all.push_back({query->value(0).toString().toStdString(), timeOf(query->value(1).toString())});
    return all;
}

core::Expected<void> StudyStore::keepAnswers(const Participant& participant,
                                             const std::optional<SessionRecord>& session,
                                             const Questionnaire& questionnaire,
                                             const std::vector<ItemAnswer>& answers, const QDateTime& now) {
    if (const core::Expected<void> fit = checkAnswers(questionnaire, answers); !fit)
        return fit;
    if (isOfSession(questionnaire.when) != session.has_value())
        return m_connection->refused(TrialsText::tr("this questionnaire belongs elsewhere in the study"),
                                     QString::fromLatin1(toString(questionnaire.when)));
    const QVariant key = session ? QVariant(session->key) : QVariant(QMetaType(QMetaType::LongLong));
    const core::Expected<void> kept = m_connection->inTransaction([&]() -> core::Expected<void> {
        for (const ItemAnswer& answer : answers) {
            const auto done = m_connection->run(
                QStringLiteral("INSERT INTO answer (participant, session, questionnaire, item, value, "
                               "time_utc) VALUES (?, ?, ?, ?, ?, ?)"),
                {participant.key, key, QString::fromStdString(questionnaire.id),
                 QString::fromStdString(answer.item), orNull(answer.value.value_or(std::string())),
                 timeText(now)});
            TELETA_CHECK(done);
        }
        return {};
    });
    if (kept || kept.error().kind != core::ErrorKind::refused)
        return kept;
    // A server that is lost during a commit does not tell whether it has them.
    TELETA_TRY(const auto stored, this->answers(participant));
    switch (compare(stored, session, questionnaire.id, answers)) {
    case KeptAnswers::same:
        return {};
    case KeptAnswers::none:
        return kept;
    case KeptAnswers::other:
        break;
    }
    return m_connection->refused(TrialsText::tr("this questionnaire has already been answered"),
                                 TrialsText::tr("each questionnaire once"));
}

core::Expected<std::vector<StoredAnswer>> StudyStore::answers(const Participant& participant) const {
    auto query = m_connection->run(
        QStringLiteral(
            "SELECT session, questionnaire, item, value, time_utc FROM answer WHERE participant = ? "
            "ORDER BY key"),
        {participant.key});
    TELETA_CHECK(query);
    std::vector<StoredAnswer> all;
    while (query->next()) {
        StoredAnswer answer;
        if (!query->value(0).isNull())
            answer.session = query->value(0).toLongLong();
        answer.questionnaire = query->value(1).toString().toStdString();
        answer.item = query->value(2).toString().toStdString();
        if (!query->value(3).isNull())
            answer.value = query->value(3).toString().toStdString();
        answer.time = timeOf(query->value(4).toString());
        all.push_back(std::move(answer));
    }
    return all;
}

} // namespace teleta::study
