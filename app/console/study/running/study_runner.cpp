// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/study_runner.h"

#include "backend/core/failure.h"
#include "backend/study/protocol/trial_pattern.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::Hold;
using study::Stage;

namespace {

/// How often the device and the time limit of a running trial are checked. Recorded times do not depend on
/// it: stimuli and presses carry their own.
constexpr int kPoll_ms = 4;
/// Checks after the limit before the trial times out: a press that was made in time may still be queued in a
/// busy event loop.
constexpr int kTurnsForInput = 3;

} // namespace

StudyRunner::StudyRunner(const core::StopSwitch& stop, Clock clock, WallClock utcNow, Keep keep,
                         QObject* parent)
    : QObject(parent)
    , m_stop(stop)
    , m_clock(std::move(clock))
    , m_utcNow(std::move(utcNow))
    , m_keep(std::move(keep)) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kPoll_ms);
    connect(&m_timer, &QTimer::timeout, this, &StudyRunner::turn);
}

core::Expected<void> StudyRunner::begin(StimulusOutput& output, const study::Protocol& protocol,
                                        const study::StimulusSet& set, const study::PlannedSession& plan,
                                        std::span<const study::TrialResult> kept, std::int64_t began_ns) {
    const study::StudyTask& task = protocol.tasks[plan.task];
    const std::string& condition = task.conditions[plan.condition];
    std::vector<std::string> ids;
    if (task.design != study::Design::identification)
        ids.push_back(study::levelStimulusId(task));
    for (const study::StudyPattern& pattern : task.patterns) {
        if (task.design == study::Design::identification)
            ids.push_back(study::stimulusId(task, pattern, condition));
    }
    std::vector<const pattern::Pattern*> stimuli;
    for (const std::string& id : ids) {
        stimuli.push_back(set.find(id));
        if (stimuli.back() == nullptr)
            return core::failed(core::ErrorKind::notFound,
                                tr("there is no tactile pattern \"%1\"").arg(QString::fromStdString(id)),
                                tr("a protocol that names a file for each pattern that is not built in"));
    }
    // So that no trial can fail later.
    if (task.design != study::Design::identification)
        TELETA_CHECK(study::checkStimulus(protocol, task, *stimuli.front()));
    TELETA_TRY(study::SessionFlow flow, study::SessionFlow::create(protocol, plan, kept, began_ns));
    clear();
    m_output = &output;
    m_flow = std::move(flow);
    m_set = set;
    m_task = task;
    m_condition = condition;
    m_stimuli = std::move(stimuli);
    m_stimulus_s = protocol.stimulus_s;
    m_flow->countAsRest();
    settle();
    emit changed();
    return {};
}

void StudyRunner::clear() {
    ++m_run;
    m_timer.stop();
    if (m_flow && m_flow->session().isRunning())
        m_output->stop();
    m_flow.reset();
    m_output = nullptr;
    m_concluded = false;
    emit changed();
}

QString StudyRunner::reason() const {
    return m_flow ? QString::fromStdString(m_flow->reason()) : QString();
}

std::size_t StudyRunner::interval() const {
    if (!m_flow || m_task.design == study::Design::identification)
        return 0;
    const std::size_t intervals = study::intervalsOf(m_task.design, m_task.levels);
    const std::optional<std::int64_t> onset_ns = m_flow->session().stimulusOnset_ns();
    if (!onset_ns || intervals < 2)
        return 0;
    const double time_s = 1e-9 * static_cast<double>(m_clock() - *onset_ns);
    const double period_s = m_stimulus_s + m_task.levels.gap_s;
    const double place = std::floor(time_s / period_s);
    const bool isFelt =
        time_s >= 0.0 && place < static_cast<double>(intervals) && time_s - place * period_s < m_stimulus_s;
    return isFelt ? static_cast<std::size_t>(place) + 1 : 0;
}

double StudyRunner::restLeft_s() const {
    return hold() == Hold::rest
               ? std::max(0.0, 1e-9 * static_cast<double>(m_flow->restUntil_ns() - m_clock()))
               : 0.0;
}

void StudyRunner::next(std::int64_t time_ns) {
    if (!m_flow)
        return;
    poll();
    letPass(time_ns);
    if (m_flow) {
        m_flow->next(time_ns);
        if (m_flow->isTrialDue())
            beginTrial(time_ns);
        settle();
    }
    emit changed();
}

void StudyRunner::beginTrial(std::int64_t time_ns) {
    if (const QString obstacle = m_output->obstacle(); !obstacle.isEmpty()) {
        m_flow->holdBack(m_stop.engaged() ? Hold::stopped : Hold::deviceLost, obstacle.toStdString());
    } else if (m_flow->startTrial(time_ns)) {
        showStimulus(time_ns);
        m_timer.start();
    }
}

void StudyRunner::showStimulus(std::int64_t time_ns) {
    const study::PlannedTrial* trial = m_flow->session().current();
    if (trial == nullptr)
        return;
    if (m_task.design == study::Design::identification) {
        m_output->begin(*m_stimuli[trial->stimulus], m_stimulus_s, OnsetFrame::notZero, time_ns);
        if (m_observer != nullptr)
            m_observer->stimulusRequested(*trial, m_output->onset());
        return;
    }
    const auto whole = study::trialPattern(m_task, m_condition, *m_stimuli.front(), m_stimulus_s, *trial);
    if (!whole) {
        fail(QString::fromStdString(core::describe(whole.error())), Hold::deviceLost, time_ns);
        return;
    }
    m_output->begin(*whole, whole->duration_s, OnsetFrame::any, time_ns);
    if (m_observer != nullptr)
        m_observer->stimulusRequested(*trial, m_output->onset());
}

void StudyRunner::replay(std::int64_t time_ns) {
    if (!m_flow)
        return;
    poll();
    if (hold() == Hold::none && m_flow->session().replay(time_ns))
        showStimulus(time_ns);
    emit changed();
}

void StudyRunner::press(const study::KeyPress& press) {
    if (!m_flow)
        return;
    // The session hears of the stimulus and the press in the order in which they happened.
    follow(press.time_ns);
    m_flow->session().press(press);
    settle();
    emit changed();
}

void StudyRunner::release(const std::string& device, const std::string& key) {
    if (m_flow)
        m_flow->session().release(device, key);
}

void StudyRunner::follow(std::int64_t until_ns) {
    study::Session& session = m_flow->session();
    if (session.stage() != Stage::starting && session.stage() != Stage::stimulus)
        return;
    const StimulusState state = m_output->state(until_ns);
    if (session.stage() == Stage::starting && state.onset_ns != 0 && state.onset_ns <= until_ns)
        session.stimulusStarted(state.onset_ns,
                                state.due_ns != 0 ? std::optional(state.due_ns) : std::nullopt);
    if (!state.failure.isEmpty())
        fail(state.failure, m_stop.engaged() ? Hold::stopped : Hold::deviceLost, until_ns);
    else if (session.stage() == Stage::stimulus && state.end_ns != 0 && state.end_ns <= until_ns)
        session.stimulusEnded(state.end_ns);
}

void StudyRunner::fail(const QString& reason, Hold why, std::int64_t time_ns) {
    m_output->stop();
    m_flow->session().deviceFailed(time_ns);
    m_flow->holdBack(why, reason.toStdString());
    settle();
}

void StudyRunner::poll() {
    if (!m_flow)
        return;
    const Stage stage = m_flow->session().stage();
    const Hold held = hold();
    const std::int64_t now_ns = m_clock();
    if (m_flow->session().isRunning()) {
        follow(now_ns);
        if (m_stop.engaged() && m_flow->session().isRunning())
            fail(tr("STOP was pressed"), Hold::stopped, now_ns);
        settle();
    } else if (m_stop.engaged() && !m_flow->waitsForExperimenter() && !m_flow->isOver()) {
        m_flow->holdBack(Hold::stopped, tr("STOP was pressed").toStdString());
    }
    const std::size_t before = std::exchange(m_interval, interval());
    if (m_flow && (stage != m_flow->session().stage() || held != hold() || before != m_interval))
        emit changed();
}

void StudyRunner::turn() {
    poll();
    const std::optional<std::int64_t> deadline = m_flow ? m_flow->session().deadline_ns() : std::nullopt;
    const std::int64_t now_ns = m_clock();
    if (!deadline || now_ns <= *deadline)
        m_turnsLate = 0;
    else if (++m_turnsLate > kTurnsForInput)
        letPass(now_ns);
}

/// All input up to this time must have been handled.
void StudyRunner::letPass(std::int64_t time_ns) {
    if (!m_flow)
        return;
    const Stage stage = m_flow->session().stage();
    m_flow->session().advance(time_ns);
    settle();
    if (m_flow && stage != m_flow->session().stage())
        emit changed();
}

/// After anything has happened in the session: passes on what follows from it. Whoever hears of the end may
/// clear the session.
void StudyRunner::settle() {
    if (!m_flow)
        return;
    if (!m_flow->session().isRunning())
        m_timer.stop();
    std::optional<study::TrialResult> result = m_flow->takeResult();
    if (result) {
        const StimulusState shown = m_output->state(m_clock());
        result->frameWrite_ms = shown.frameWrite_ms;
        result->framesMissed = shown.framesMissed;
        result->latencySpread_ms = shown.latencySpread_ms;
        if (m_observer != nullptr)
            m_observer->trialEnded(*result, shown.onset_ns, m_clock());
        // The answer ends the stimulus.
        m_output->stop();
        m_last = std::move(*result);
        m_ended = m_utcNow();
        m_flow->keeping(m_last);
    }
    m_flow->settle(m_clock());
    if (m_flow->isOver() && !std::exchange(m_concluded, true)) {
        if (m_flow->session().stage() == Stage::aborted) {
            emit aborted();
        } else {
            emit blockKept();
            emit finished();
        }
    }
    // Comes last: the store may call back at once.
    if (result)
        keep();
}

void StudyRunner::keep() {
    m_keep(m_last, m_ended, [this, run = m_run](const core::Expected<void>& outcome) {
        if (run != m_run)
            return;
        m_flow->kept(outcome);
        if (m_flow->isPracticeKept())
            emit blockKept();
        settle();
        if (m_flow && m_flow->isTrialDue())
            beginTrial(m_clock());
        emit changed();
    });
}

void StudyRunner::pause() {
    if (!m_flow)
        return;
    m_flow->pause();
    emit changed();
}

void StudyRunner::goOn() {
    if (!m_flow || hold() == Hold::notKept || m_stop.engaged())
        return;
    if (const QString obstacle = m_output->obstacle(); hold() != Hold::none && !obstacle.isEmpty())
        m_flow->holdBack(Hold::deviceLost, obstacle.toStdString());
    else
        m_flow->goOn();
    emit changed();
}

void StudyRunner::abort() {
    if (!m_flow || m_flow->isOver())
        return;
    m_output->stop();
    m_flow->abort(m_clock());
    settle();
    emit changed();
}

void StudyRunner::retry() {
    if (!m_flow || hold() != Hold::notKept)
        return;
    m_flow->retry();
    keep();
    emit changed();
}

const study::SessionFlow* StudyRunner::flow() const {
    return m_flow ? &*m_flow : nullptr;
}

const study::Session* StudyRunner::session() const {
    return m_flow ? &m_flow->session() : nullptr;
}

} // namespace teleta::console
