// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/rehearsal.h"

#include "backend/study/due_questionnaires.h"
#include "backend/study/session.h"
#include "backend/study/simulated_participant.h"
#include "backend/study/study_export.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::study {

namespace {

struct RehearsalText {
    Q_DECLARE_TR_FUNCTIONS(StudyRehearsal)
};

constexpr std::int64_t kLatency_ns = 5'000'000;
constexpr std::int64_t kBetweenTrials_ns = 1'000'000'000;
constexpr qint64 kBetweenSessions_s = 3600;
constexpr std::uint64_t kAnswersOfSession = 2; // parts 0 and 1 of the session's seed are its orders

/// Shows one trial to the participant and passes on what it does.
void showTrial(Session& session, const SimulatedParticipant& participant, double stimulus_s,
               std::uint64_t seed, std::int64_t& now_ns) {
    PortableRandom random(seed);
    const SimulatedParticipant::Answer answer = participant.answer(session.current()->stimulus, random);
    now_ns += kBetweenTrials_ns;
    if (!session.startTrial(now_ns))
        return;
    const std::int64_t onset_ns = now_ns + kLatency_ns;
    const std::int64_t end_ns = onset_ns + std::llround(stimulus_s * 1e9);
    const std::int64_t answer_ns = onset_ns + std::llround(answer.time_s * 1e9);
    session.stimulusStarted(onset_ns);
    now_ns = end_ns;
    const KeyPress press{answer.response, "simulated", std::to_string(answer.response.value_or(0) + 1),
                         answer_ns, false};
    if (answer.response && answer_ns < end_ns) {
        session.press(press);
        session.release(press.device, press.key);
    }
    session.stimulusEnded(end_ns);
    if (answer.response && answer_ns >= end_ns) {
        now_ns = answer_ns;
        session.press(press);
        session.release(press.device, press.key);
    }
    if (const std::optional<std::int64_t> deadline = session.deadline_ns()) {
        now_ns = *deadline + 1;
        session.advance(now_ns);
    }
}

class Rehearsal {
public:
    Rehearsal(StudyStore& store, const std::function<bool(std::size_t)>& goOn)
        : m_store(store)
        , m_goOn(goOn) {}

    [[nodiscard]] core::Expected<RehearsalProgress> run();

private:
    [[nodiscard]] core::Expected<void> runSession(const Participant& participant, std::size_t planIndex,
                                                  const PlannedSession& plan, const QDateTime& begin);
    /// Those that are due then and were not answered before an interruption.
    [[nodiscard]] core::Expected<void> answerQuestionnaires(QuestionnaireTime when,
                                                            const Participant& participant,
                                                            const SessionRecord& session,
                                                            const PlannedSession& plan, const QDateTime& now);

    StudyStore& m_store;
    const std::function<bool(std::size_t)>& m_goOn;
    RehearsalProgress m_progress;
};

core::Expected<RehearsalProgress> Rehearsal::run() {
    const StudyHead& head = m_store.head();
    if (head.mode != Mode::simulated)
        return core::Unexpected(
            core::Error{core::ErrorKind::refused,
                        RehearsalText::tr("this study has real participants").toStdString(),
                        RehearsalText::tr("a study that was begun as a rehearsal").toStdString(),
                        {m_store.folder()}});
    core::Expected<std::vector<Participant>> enrolled = m_store.participants();
    if (!enrolled)
        return core::Unexpected(enrolled.error());
    for (std::size_t i = 0; i < head.plannedParticipants && !m_progress.interrupted; ++i) {
        if (i == enrolled->size()) {
            const core::Expected<Participant> participant =
                m_store.enrol(QStringLiteral("P%1").arg(i + 1, 2, 10, QLatin1Char('0')).toStdString());
            if (!participant)
                return core::Unexpected(participant.error());
            enrolled->push_back(*participant);
        }
        const std::vector<PlannedSession> plan =
            planSessions(head.protocol, head.seed, (*enrolled)[i].enrolment);
        const Participant& participant = (*enrolled)[i];
        const core::Expected<ParticipantClaim> claim = m_store.claim(participant);
        if (!claim)
            return core::Unexpected(claim.error());
        const auto beginOf = [&](std::size_t session) {
            return head.created.addSecs(static_cast<qint64>(participant.enrolment * plan.size() + session) *
                                        kBetweenSessions_s);
        };
        core::Expected<void> done =
            answerQuestionnaires(QuestionnaireTime::beforeStudy, participant, {}, {}, beginOf(0));
        for (std::size_t j = 0; done && j < plan.size() && !m_progress.interrupted; ++j)
            done = runSession(participant, j, plan[j], beginOf(j));
        if (done && !m_progress.interrupted)
            done =
                answerQuestionnaires(QuestionnaireTime::afterStudy, participant, {}, {}, beginOf(plan.size()))
                    .and_then([&] { return exportAnswers(m_store, participant, ExportFormat::psychds); });
        if (!done)
            return core::Unexpected(done.error());
        m_progress.participants += m_progress.interrupted ? 0 : 1;
    }
    return m_progress;
}

core::Expected<void> Rehearsal::answerQuestionnaires(QuestionnaireTime when, const Participant& participant,
                                                     const SessionRecord& session, const PlannedSession& plan,
                                                     const QDateTime& now) {
    const StudyHead& head = m_store.head();
    if (head.protocol.questionnaires.empty())
        return {};
    const core::Expected<std::vector<StoredAnswer>> kept = m_store.answers(participant);
    if (!kept)
        return core::Unexpected(kept.error());
    for (const DueQuestionnaire& due : dueQuestionnaires(head.protocol, when, session, *kept)) {
        const core::Expected<void> safe =
            m_store.keepAnswers(participant, due.session, head.protocol.questionnaires[due.index],
                                simulatedAnswers(head, participant, plan, due.index), now);
        if (!safe)
            return safe;
    }
    return {};
}

core::Expected<void> Rehearsal::runSession(const Participant& participant, std::size_t planIndex,
                                           const PlannedSession& plan, const QDateTime& begin) {
    const StudyHead& head = m_store.head();
    const core::Expected<SessionRecord> record = m_store.beginSession(participant, planIndex, plan, begin);
    if (!record)
        return core::Unexpected(record.error());
    if (const auto answered =
            answerQuestionnaires(QuestionnaireTime::beforeSession, participant, *record, plan, begin);
        !answered)
        return answered;
    const core::Expected<std::vector<StoredTrial>> kept = m_store.trials(*record);
    if (!kept)
        return core::Unexpected(kept.error());
    std::vector<TrialResult> done;
    std::int64_t now_ns = 0;
    for (const StoredTrial& trial : *kept) {
        done.push_back(trial.result);
        now_ns = begin.msecsTo(trial.time) * 1'000'000;
    }
    m_progress.trialsBefore += done.size();
    core::Expected<Session> session = Session::create(head.protocol, plan, done, 0);
    if (!session)
        return core::Unexpected(session.error());

    const StudyTask& task = head.protocol.tasks[plan.task];
    SimulatedParticipant simulated{
        paperMatrix(task.id, task.conditions[plan.condition]).value_or(assumedMatrix(task.patterns.size())),
        head.lapses};
    if (simulated.matrix.patterns() != task.patterns.size())
        simulated.matrix = assumedMatrix(task.patterns.size());
    while (session->stage() == Stage::ready) {
        if (!m_goOn(m_progress.trialsBefore + m_progress.trials)) {
            m_progress.interrupted = true;
            return {};
        }
        const PlannedTrial trial = *session->current();
        const std::uint64_t part =
            (trial.trial << 16U) + (trial.attempt << 1U) + (trial.phase == Phase::test ? 1 : 0);
        showTrial(*session, simulated, head.protocol.stimulus_s,
                  derivedSeed(derivedSeed(plan.seed, kAnswersOfSession), part), now_ns);
        // The store keeps milliseconds, and the next trial begins at what it keeps, resumed or not.
        now_ns = (now_ns + 999'999) / 1'000'000 * 1'000'000;
        if (const std::optional<TrialResult> result = session->takeResult()) {
            const core::Expected<void> safe =
                m_store.keepTrial(*record, *result, begin.addMSecs(now_ns / 1'000'000));
            if (!safe)
                return safe;
            ++m_progress.trials;
        }
        session->feedbackSeen();
    }
    if (const auto answered = answerQuestionnaires(QuestionnaireTime::afterSession, participant, *record,
                                                   plan, begin.addMSecs(now_ns / 1'000'000));
        !answered)
        return answered;
    if (record->finished)
        return {};
    // Before it counts as finished, so that a resumed rehearsal writes what an interrupted one did not.
    if (const core::Expected<void> written =
            exportSession(m_store, participant, *record, ExportFormat::psychds);
        !written)
        return written;
    return m_store.finishSession(*record);
}

} // namespace

std::size_t plannedTrials(const StudyHead& head) {
    std::size_t trials = 0;
    const std::vector<PlannedSession> plan = planSessions(head.protocol, head.seed, 0);
    for (const PlannedSession& session : plan)
        trials += session.practice.size() + session.test.size();
    return trials * head.plannedParticipants;
}

core::Expected<RehearsalProgress> rehearse(StudyStore& store, const std::function<bool(std::size_t)>& goOn) {
    return Rehearsal(store, goOn).run();
}

} // namespace teleta::study
