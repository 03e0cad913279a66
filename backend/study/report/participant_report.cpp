// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/participant_report.h"

#include "backend/core/failure.h"
#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/protocol/standard_questionnaire.h"
#include "backend/study/report/confusion_figure.h"
#include "backend/study/report/exports/export_parts.h"
#include "backend/study/report/report_html.h"
#include "backend/study/report/report_page.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::study {

namespace {

using namespace report_html;

struct PersonText {
    Q_DECLARE_TR_FUNCTIONS(ParticipantReport)
};

/// A session and what its test trials gave.
struct SessionSummary {
    SessionRecord record;
    const StudyTask* task = nullptr;
    std::string condition;
    std::int64_t trials = 0; ///< completed test trials
    std::int64_t correct = 0;
    std::int64_t unanswered = 0;
    std::size_t faults = 0;
    std::vector<double> times_s; ///< of correct answers
    std::optional<ConfusionMatrix> matrix;
    std::vector<StoredNote> notes;
};

QString number(double value, int digits) {
    return QString::number(value, 'f', digits);
}

int wholePercent(double share) {
    return static_cast<int>(std::lround(100.0 * share));
}

core::Expected<std::vector<SessionSummary>> summaries(const StudyStore& store,
                                                      const Participant& participant) {
    const StudyHead& head = store.head();
    TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
    const std::vector<PlannedSession> plans = planSessions(head.protocol, head.seed, participant.enrolment);
    std::vector<SessionSummary> made;
    for (const SessionRecord& record : sessions) {
        const PlannedSession& plan = plans.at(record.planIndex);
        SessionSummary summary;
        summary.record = record;
        summary.task = &head.protocol.tasks[plan.task];
        summary.condition = summary.task->conditions[plan.condition];
        if (!summary.task->patterns.empty())
            summary.matrix.emplace(summary.task->patterns.size());
        TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(record));
        TELETA_TRY(summary.notes, store.notes(record));
        for (const StoredTrial& stored : trials) {
            const TrialResult& result = stored.result;
            if (result.outcome == Outcome::deviceError)
                ++summary.faults;
            if (result.planned.phase != Phase::test || !result.isComplete())
                continue;
            ++summary.trials;
            summary.unanswered += result.outcome == Outcome::timeout ? 1 : 0;
            if (result.outcome == Outcome::correct) {
                ++summary.correct;
                if (result.responseTime_s)
                    summary.times_s.push_back(*result.responseTime_s);
            }
            if (summary.matrix)
                summary.matrix->add(result.planned.stimulus, result.response);
        }
        made.push_back(std::move(summary));
    }
    return made;
}

double shareOf(const SessionSummary& session) {
    return static_cast<double>(session.correct) / static_cast<double>(session.trials);
}

/// Names of the patterns that were recognised most often, if all trials of them were right.
QStringList surest(const SessionSummary& session) {
    QStringList names;
    if (!session.matrix)
        return names;
    for (std::size_t i = 0; i < session.task->patterns.size(); ++i) {
        if (session.matrix->rowTotal(i) > 0 && session.matrix->count(i, i) == session.matrix->rowTotal(i))
            names << text(session.task->patterns[i].name);
    }
    return names;
}

/// In plain words.
QString wordsFor(const SessionSummary& session) {
    QString body = QStringLiteral("<h2>%1</h2>\n")
                       .arg(QStringLiteral("%1, %2")
                                .arg(text(session.task->name), text(session.condition))
                                .toHtmlEscaped());
    if (session.trials == 0)
        return body + paragraph(PersonText::tr("In this part nothing was tested yet."));
    body += paragraph(PersonText::tr("You answered %1 of %2 trials correctly: %3 %.", "numbers")
                          .arg(session.correct)
                          .arg(session.trials)
                          .arg(wholePercent(shareOf(session))));
    const std::size_t choices = session.task->patterns.size();
    if (choices > 1)
        body += paragraph(
            PersonText::tr("There were %1 possible answers. Whoever guesses is right in about %2 % of "
                           "the trials.")
                .arg(choices)
                .arg(wholePercent(1.0 / static_cast<double>(choices))));
    if (session.unanswered > 0)
        body += paragraph(PersonText::tr("In %n trial(s) the time was over before you answered.", nullptr,
                                         static_cast<int>(session.unanswered)));
    if (const std::optional<double> time_s = median(session.times_s))
        body += paragraph(
            PersonText::tr("Half of your correct answers came within %1 seconds.").arg(number(*time_s, 1)));
    if (const QStringList names = surest(session); !names.isEmpty())
        body += paragraph(PersonText::tr("You recognised these every time: %1.")
                              .arg(names.join(PersonText::tr(", ", "between names"))));
    if (!session.record.finished)
        body += paragraph(PersonText::tr("This part was not finished."));
    return body;
}

QString wordsFor(const std::vector<SessionSummary>& sessions, const Protocol& protocol) {
    QString body =
        paragraph(PersonText::tr("Thank you for taking part in the study \"%1\".").arg(text(protocol.name)));
    if (sessions.empty())
        body += paragraph(PersonText::tr("You have not begun yet."));
    for (const SessionSummary& session : sessions)
        body += wordsFor(session);
    return body +
           paragraph(PersonText::tr("This page has your answers alone. They say how well these vibrations "
                                    "can be told apart on this bracelet; they are no test of health."));
}

QString sessionTable(const std::vector<SessionSummary>& sessions) {
    HtmlTable table(PersonText::tr("Completed test trials of each session; the interval is Wilson's (95 %)"),
                    {PersonText::tr("Session"), PersonText::tr("Task"), PersonText::tr("Condition"),
                     PersonText::tr("Finished"), PersonText::tr("Correct"), PersonText::tr("%"),
                     PersonText::tr("Interval, %"), PersonText::tr("No answer"),
                     PersonText::tr("Device faults"), PersonText::tr("Median time, s")});
    const QString missing = QStringLiteral("NA");
    for (const SessionSummary& session : sessions) {
        const std::optional<Interval> ends = wilsonInterval(session.correct, session.trials);
        const std::optional<double> time_s = median(session.times_s);
        table.row({text(session.record.id), text(session.task->id), text(session.condition),
                   session.record.finished ? PersonText::tr("yes") : PersonText::tr("no"),
                   QStringLiteral("%1/%2").arg(session.correct).arg(session.trials),
                   session.trials > 0 ? number(100.0 * shareOf(session), 1) : missing,
                   ends ? QStringLiteral("%1 \u2013 %2")
                              .arg(number(100.0 * ends->low, 1), number(100.0 * ends->high, 1))
                        : missing,
                   QString::number(session.unanswered), QString::number(session.faults),
                   time_s ? number(*time_s, 2) : missing},
                  3);
    }
    return table.html();
}

QString confusionsOf(const std::vector<SessionSummary>& sessions, std::optional<Mode> mode) {
    QString body;
    for (const SessionSummary& session : sessions) {
        if (session.trials == 0 || !session.matrix)
            continue;
        std::vector<std::string> letters;
        for (const StudyPattern& pattern : session.task->patterns)
            letters.push_back(pattern.letter);
        const std::string title = session.task->id + ", " + session.condition;
        body += report_html::figure(
            confusionFigure(*session.matrix, letters, title, ConfusionValues::counts, mode),
            PersonText::tr("Rows: presented; columns: answered. Number of trials."));
    }
    return body.isEmpty() ? body : QStringLiteral("<div class=\"beside\">\n%1</div>\n").arg(body);
}

core::Expected<QString> questionnairesOf(const StudyStore& store, const Participant& participant,
                                         const std::vector<SessionSummary>& sessions) {
    TELETA_TRY(const std::vector<StoredAnswer> answers, store.answers(participant));
    QString body;
    const auto add = [&](const Questionnaire& questionnaire, const SessionSummary* session) {
        const std::vector<ItemAnswer> given =
            answersTo(questionnaire, session != nullptr ? &session->record : nullptr, answers);
        if (given.empty())
            return;
        const QString place =
            session == nullptr
                ? QString()
                : QStringLiteral(" (%1, %2)").arg(text(session->task->id), text(session->condition));
        HtmlTable table(text(questionnaire.title) + place,
                        {PersonText::tr("Question"), PersonText::tr("Answer")});
        for (const QuestionnaireItem& item : questionnaire.items) {
            const auto answer = std::ranges::find(given, item.id, &ItemAnswer::item);
            const bool has = answer != given.end() && answer->value;
            table.row({text(item.question),
                       has ? text(shownAnswer(item, answer->value)) : PersonText::tr("no answer")});
        }
        for (const QuestionnaireScore& score : questionnaireScores(questionnaire, given))
            table.row({text(score.name), score.value ? number(*score.value, 2) : QStringLiteral("NA")});
        body += table.html();
    };
    for (const Questionnaire& questionnaire : store.head().protocol.questionnaires) {
        if (!isOfSession(questionnaire.when))
            add(questionnaire, nullptr);
        for (const SessionSummary& session : sessions) {
            if (isOfSession(questionnaire.when))
                add(questionnaire, &session);
        }
    }
    return body.isEmpty() ? body
                          : QStringLiteral("<h2>%1</h2>\n%2")
                                .arg(PersonText::tr("Questionnaires").toHtmlEscaped(), body);
}

QString notesOf(const std::vector<SessionSummary>& sessions) {
    QString body;
    for (const SessionSummary& session : sessions) {
        for (const StoredNote& note : session.notes)
            body += paragraph(QStringLiteral("%1: %2").arg(note.time.toString(Qt::ISODate), text(note.text)));
    }
    return body.isEmpty()
               ? body
               : QStringLiteral("<h2>%1</h2>\n%2").arg(PersonText::tr("Notes").toHtmlEscaped(), body);
}

} // namespace

core::Expected<std::string> participantReport(const StudyStore& store, const std::string& id,
                                              ReportReader reader) {
    const StudyHead& head = store.head();
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    const auto found = std::ranges::find(participants, id, &Participant::id);
    if (found == participants.end())
        return core::failed(core::ErrorKind::notFound,
                            PersonText::tr("the study has no participant \"%1\"").arg(text(id)), {},
                            {store.shownName()});
    TELETA_TRY(const std::vector<SessionSummary> sessions, summaries(store, *found));
    if (reader == ReportReader::participant)
        return reportPage(PersonText::tr("Your results"), head.mode, wordsFor(sessions, head.protocol))
            .toStdString();
    TELETA_TRY(const QString questionnaires, questionnairesOf(store, *found, sessions));
    QString body = paragraph(PersonText::tr("Study: %1. Participant %2 in the order of enrolment.")
                                 .arg(text(head.protocol.name))
                                 .arg(found->enrolment + 1));
    body += sessions.empty() ? paragraph(PersonText::tr("No session has begun."))
                             : sessionTable(sessions) + confusionsOf(sessions, head.mode);
    body += questionnaires + notesOf(sessions);
    return reportPage(PersonText::tr("Participant %1", "an id").arg(text(id)), head.mode, body).toStdString();
}

} // namespace teleta::study
