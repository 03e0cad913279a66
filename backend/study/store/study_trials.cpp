// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/study/store/store_values.h"
#include "backend/study/store/study_store.h"
#include "backend/study/store/trial_fields.h"
#include "backend/study/store/trial_journal.h"

#include <QCoreApplication>
#include <QStringList>

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
        same += static_cast<std::size_t>(std::ranges::count_if(answers, [&](const ItemAnswer& answer) {
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
    QStringList names{QStringLiteral("session")};
    QVariantList values{session};
    forEachField(trial, [&](const char* name, const auto& field) {
        names << QLatin1String(name);
        values << sqlValue(field);
    });
    const auto kept =
        m_connection->run(QStringLiteral("INSERT INTO trial (%1) VALUES (%2)")
                              .arg(names.join(QStringLiteral(", ")),
                                   QStringList(names.size(), QStringLiteral("?")).join(QStringLiteral(", "))),
                          values);
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
    TELETA_TRY(auto query,
               m_connection->run(
                   QStringLiteral(
                       "SELECT outcome, response, response_time_s, stimulus, onset_s, duration_s FROM trial "
                       "WHERE session = ? AND phase = ? AND trial = ? AND attempt = ?"),
                   {session, sqlValue(result.planned.phase), sqlValue(result.planned.trial),
                    sqlValue(result.planned.attempt)}));
    std::optional<double> responseTime_s;
    readInto(query.next() ? query.value(2) : QVariant(), responseTime_s);
    const bool isSame =
        query.isValid() && stringOf(query.value(0)) == toString(result.outcome) &&
        query.value(1).isNull() == !result.response && count(query.value(1)) == result.response.value_or(0) &&
        responseTime_s == result.responseTime_s && count(query.value(3)) == result.planned.stimulus &&
        query.value(4).toDouble() == result.onset_s && query.value(5).toDouble() == result.duration_s;
    return isSame ? core::Expected<void>() : kept;
}

core::Expected<void> StudyStore::sendPending(long long session) {
    const TrialJournal journal(folder(), session);
    TELETA_TRY(const std::vector<PendingTrial> pending, journal.read());
    if (pending.empty())
        return journal.remove();
    TELETA_TRY(auto query,
               m_connection->run(QStringLiteral("SELECT id FROM session WHERE key = ?"), {session}));
    const std::string id = query.next() ? stringOf(query.value(0)) : std::string();
    for (const PendingTrial& trial : pending) {
        if (trial.sessionKey != session || trial.sessionId != id)
            return core::failed(core::ErrorKind::badInput,
                                TrialsText::tr("these trials belong to another study"),
                                TrialsText::tr("a separate folder for each study"), {journal.path()});
        TELETA_CHECK(insertUnlessKept(session, {trial.result, trial.time}));
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
    // Another error between two attempts leaves that open too.
    m_unsure = isAway || (m_unsure && !kept);
    if (!isAway)
        return kept;
    const TrialJournal journal(folder(), session.key);
    TELETA_TRY(const std::vector<PendingTrial> pending, journal.read());
    const bool isPending = std::ranges::any_of(pending, [&](const PendingTrial& other) {
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
    QStringList names;
    StoredTrial trial;
    forEachField(trial, [&](const char* name, const auto&) { names << QLatin1String(name); });
    TELETA_TRY(auto query,
               m_connection->run(QStringLiteral("SELECT %1 FROM trial WHERE session = ? ORDER BY key")
                                     .arg(names.join(QStringLiteral(", "))),
                                 {session.key}));
    // The tasks come in the same order for everybody.
    const std::vector<PlannedSession> plan = planSessions(m_head.protocol, m_head.seed, 0);
    if (session.planIndex >= plan.size())
        return m_connection->damaged();
    const std::size_t patterns = m_head.protocol.tasks[plan[session.planIndex].task].patterns.size();
    std::vector<StoredTrial> all;
    while (query.next()) {
        trial = {};
        int column = 0;
        forEachField(trial, [&](const char*, auto& field) { readInto(query.value(column++), field); });
        if (trial.result.planned.stimulus >= patterns || trial.result.response.value_or(0) >= patterns)
            return m_connection->damaged();
        all.push_back(trial);
    }
    return all;
}

core::Expected<void> StudyStore::keepNote(const SessionRecord& session, const std::string& text,
                                          const QDateTime& now) {
    TELETA_CHECK(
        m_connection->run(QStringLiteral("INSERT INTO note (session, text, time_utc) VALUES (?, ?, ?)"),
                          {session.key, QString::fromStdString(text), timeText(now)}));
    return {};
}

core::Expected<std::vector<StoredNote>> StudyStore::notes(const SessionRecord& session) const {
    TELETA_TRY(
        auto query,
        m_connection->run(QStringLiteral("SELECT text, time_utc FROM note WHERE session = ? ORDER BY key"),
                          {session.key}));
    std::vector<StoredNote> all;
    while (query.next())
        all.push_back({stringOf(query.value(0)), timeOf(query.value(1).toString())});
    return all;
}

core::Expected<void> StudyStore::keepAnswers(const Participant& participant,
                                             const std::optional<SessionRecord>& session,
                                             const Questionnaire& questionnaire,
                                             const std::vector<ItemAnswer>& answers, const QDateTime& now) {
    TELETA_CHECK(checkAnswers(questionnaire, answers));
    if (isOfSession(questionnaire.when) != session.has_value())
        return m_connection->refused(TrialsText::tr("this questionnaire belongs elsewhere in the study"),
                                     QString::fromLatin1(toString(questionnaire.when)));
    const QVariant key = session ? QVariant(session->key) : QVariant(QMetaType(QMetaType::LongLong));
    const core::Expected<void> kept = m_connection->inTransaction([&]() -> core::Expected<void> {
        for (const ItemAnswer& answer : answers) {
            TELETA_CHECK(m_connection->run(
                QStringLiteral("INSERT INTO answer (participant, session, questionnaire, item, value, "
                               "time_utc) VALUES (?, ?, ?, ?, ?, ?)"),
                {participant.key, key, QString::fromStdString(questionnaire.id),
                 QString::fromStdString(answer.item), sqlValue(answer.value.value_or(std::string())),
                 timeText(now)}));
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
    TELETA_TRY(
        auto query,
        m_connection->run(
            QStringLiteral(
                "SELECT session, questionnaire, item, value, time_utc FROM answer WHERE participant = ? "
                "ORDER BY key"),
            {participant.key}));
    std::vector<StoredAnswer> all;
    while (query.next()) {
        StoredAnswer answer;
        if (!query.value(0).isNull())
            answer.session = query.value(0).toLongLong();
        answer.questionnaire = stringOf(query.value(1));
        answer.item = stringOf(query.value(2));
        readInto(query.value(3), answer.value);
        answer.time = timeOf(query.value(4).toString());
        all.push_back(std::move(answer));
    }
    return all;
}

} // namespace teleta::study
