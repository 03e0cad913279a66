// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/rehearsal.h"

#include "backend/core/failure.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/protocol/trial_pattern.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/session/due_questionnaires.h"
#include "backend/study/session/session_flow.h"
#include "backend/study/session/simulated_observer.h"
#include "backend/study/session/simulated_participant.h"

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

constexpr std::int64_t kBetweenTrials_ns = 1'000'000'000;
constexpr qint64 kBetweenSessions_s = 3600;

/// What is felt in a trial: a pattern that ends by itself or is cut off.
struct Stimulus {
    std::optional<pattern::Pattern> made; ///< of a task with levels
    const pattern::Pattern* known = nullptr;
    double atMost_s = 0.0;

    [[nodiscard]] const pattern::Pattern* pattern() const { return made ? &*made : known; }
    [[nodiscard]] double length_s() const {
        return pattern() == nullptr ? atMost_s : std::min(pattern()->duration_s, atMost_s);
    }
};

core::Expected<Stimulus> stimulusOf(const StudyHead& head, const StudyTask& task,
                                    const std::string& condition, const PlannedTrial& trial) {
    const double stimulus_s = head.protocol.stimulus_s;
    if (task.design == Design::identification)
        return Stimulus{
            {}, head.stimuli.find(stimulusId(task, task.patterns[trial.stimulus], condition)), stimulus_s};
    Stimulus stimulus{{}, nullptr, trialLength_s(task, stimulus_s)};
    if (const pattern::Pattern* base = head.stimuli.find(levelStimulusId(task))) {
        TELETA_TRY(stimulus.made, trialPattern(task, condition, *base, stimulus_s, trial));
    }
    return stimulus;
}

/// Shows one trial to the participant and passes on the answer.
void showTrial(SessionFlow& flow, const SimulatedParticipant::Answer& answer,
               const RehearsalCast::Shown& shown, double stimulus_s, std::int64_t& now_ns) {
    now_ns += kBetweenTrials_ns;
    flow.next(now_ns);
    if (!flow.startTrial(now_ns))
        return;
    Session& session = flow.session();
    const std::int64_t onset_ns = now_ns + std::llround(shown.latency_s * 1e9);
    const std::int64_t end_ns = onset_ns + std::llround(stimulus_s * 1e9);
    const std::int64_t answer_ns = onset_ns + std::llround(answer.time_s * 1e9);
    session.stimulusStarted(onset_ns, end_ns);
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
    Rehearsal(StudyStore& store, const RehearsalCast& cast)
        : m_store(store)
        , m_cast(cast) {}

    [[nodiscard]] core::Expected<RehearsalProgress> run();

private:
    [[nodiscard]] core::Expected<void> runSession(const Participant& participant, std::size_t planIndex,
                                                  const PlannedSession& plan, const QDateTime& begin);
    /// Those that are due then and not answered yet.
    [[nodiscard]] core::Expected<void> answerQuestionnaires(QuestionnaireTime when,
                                                            const Participant& participant,
                                                            const SessionRecord& session,
                                                            const PlannedSession& plan, const QDateTime& now);

    StudyStore& m_store;
    const RehearsalCast& m_cast;
    RehearsalProgress m_progress;
};

core::Expected<RehearsalProgress> Rehearsal::run() {
    const StudyHead& head = m_store.head();
    if (head.mode != Mode::simulated)
        return core::failed(core::ErrorKind::refused, RehearsalText::tr("this study has real participants"),
                            RehearsalText::tr("a study created as a rehearsal"), {m_store.folder()});
    TELETA_TRY(std::vector<Participant> enrolled, m_store.participants());
    for (std::size_t i = 0; i < head.plannedParticipants && !m_progress.interrupted; ++i) {
        if (i == enrolled.size()) {
            TELETA_TRY(
                const Participant participant,
                m_store.enrol(QStringLiteral("P%1").arg(i + 1, 2, 10, QLatin1Char('0')).toStdString()));
            enrolled.push_back(participant);
        }
        const std::vector<PlannedSession> plan =
            planSessions(head.protocol, head.seed, enrolled[i].enrolment);
        const Participant& participant = enrolled[i];
        TELETA_CHECK(m_store.claim(participant));
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
                    .and_then([&] { return exportAnswers(m_store, participant); });
        TELETA_CHECK(done);
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
    TELETA_TRY(const std::vector<StoredAnswer> kept, m_store.answers(participant));
    for (const DueQuestionnaire& due : dueQuestionnaires(head.protocol, when, session, kept)) {
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
    TELETA_TRY(const SessionRecord record, m_store.beginSession(participant, planIndex, plan, begin));
    TELETA_CHECK(answerQuestionnaires(QuestionnaireTime::beforeSession, participant, record, plan, begin));
    const core::Expected<std::vector<StoredTrial>> kept = m_store.trials(record);
    TELETA_CHECK(kept);
    std::vector<TrialResult> done;
    std::int64_t now_ns = 0;
    for (const StoredTrial& trial : *kept) {
        done.push_back(trial.result);
        now_ns = begin.msecsTo(trial.time) * 1'000'000;
    }
    m_progress.trialsBefore += done.size();
    TELETA_TRY(SessionFlow flow, SessionFlow::create(head.protocol, plan, done, 0));

    const StudyTask& task = head.protocol.tasks[plan.task];
    const std::string& condition = task.conditions[plan.condition];
    const bool hasLevels = task.design != Design::identification;
    const SimulatedParticipant simulated{
        hasLevels ? std::nullopt : std::optional(knownMatrix(task, condition)), head.lapses,
        hasLevels ? SimulatedObserver::kMedianResponse_s : SimulatedParticipant().medianResponse_s};
    TELETA_TRY(const SimulatedObserver observer, SimulatedObserver::parse(head.observer));
    const std::uint64_t person = observerSeed(head.seed, participant.enrolment);
    const PsychometricFunction function = observer.functionOf(task, condition, person);
    // The last interval has to be over before an answer counts.
    const auto observe = [&](const PlannedTrial& trial, std::uint64_t seed) {
        if (m_cast.observe)
            return m_cast.observe(task, condition, trial, person, seed);
        SimulatedParticipant::Answer answer{std::nullopt, trialLength_s(task, head.protocol.stimulus_s) +
                                                              simulated.time_s(seed)};
        if (!simulated.isLapse(seed))
            answer.response = SimulatedObserver::answer(function, task, trial, seed);
        return answer;
    };
    const std::int64_t start_ns = now_ns;
    const double before_s = m_progress.simulated_s;
    // An interruption is no rest: a resumed rehearsal rests where an uninterrupted one does.
    flow.settle(now_ns);
    while (const PlannedTrial* current = flow.session().current()) {
        if (m_cast.goOn && !m_cast.goOn(m_progress)) {
            m_progress.interrupted = true;
            return {};
        }
        const PlannedTrial trial = *current;
        const std::uint64_t seed = answerSeed(plan.seed, trial);
        const SimulatedParticipant::Answer answer = hasLevels ? observe(trial, seed)
                                                    : m_cast.answer
                                                        ? m_cast.answer(task, condition, trial.stimulus, seed)
                                                        : simulated.answer(trial.stimulus, seed);
        TELETA_TRY(const Stimulus stimulus, stimulusOf(head, task, condition, trial));
        const RehearsalCast::Shown shown =
            m_cast.show ? m_cast.show(stimulus.pattern(), stimulus.atMost_s, seed) : RehearsalCast::Shown{};
        if (flow.hold() == Hold::rest)
            now_ns = flow.restUntil_ns();
        else
            flow.goOn(); // nobody has to be asked whether the test may begin
        showTrial(flow, answer, shown, stimulus.length_s(), now_ns);
        // The store keeps milliseconds; the next trial starts at the stored time, so that a resumed rehearsal
        // is the same.
        now_ns = (now_ns + 999'999) / 1'000'000 * 1'000'000;
        m_progress.simulated_s = before_s + static_cast<double>(now_ns - start_ns) * 1e-9;
        TrialResult result = flow.takeResult().value();
        result.framesMissed = shown.framesMissed;
        flow.keeping(result);
        const core::Expected<void> safe =
            m_store.keepTrial(record, result, begin.addMSecs(now_ns / 1'000'000));
        if (!safe)
            return safe;
        flow.kept({});
        ++m_progress.trials;
        flow.settle(now_ns);
        flow.next(now_ns);
    }
    TELETA_CHECK(answerQuestionnaires(QuestionnaireTime::afterSession, participant, record, plan,
                                      begin.addMSecs(now_ns / 1'000'000)));
    if (record.finished)
        return {};
    // Before it counts as finished, so that a resumed rehearsal exports what an interrupted one did not.
    TELETA_CHECK(exportSession(m_store, participant, record));
    return m_store.finishSession(record);
}

} // namespace

std::size_t plannedTrials(const StudyHead& head) {
    std::size_t trials = 0;
    const std::vector<PlannedSession> plan = planSessions(head.protocol, head.seed, 0);
    for (const PlannedSession& session : plan)
        trials += session.practiceTrials + session.testTrials;
    return trials * head.plannedParticipants;
}

core::Expected<RehearsalProgress> rehearse(StudyStore& store, const RehearsalCast& cast) {
    return Rehearsal(store, cast).run();
}

} // namespace teleta::study
