// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/study_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::Outcome;
using study::Phase;
using study::Stage;

namespace {

/// How often a running trial looks at its device and its limit. Times do not depend on it: stimuli and
/// presses carry their own.
constexpr int kPoll_ms = 4;
/// How often it looks once more after the limit before the limit counts: a press that was made in time may
/// wait behind whatever kept the event loop.
constexpr int kTurnsForInput = 3;

bool isRunning(Stage stage) {
    return stage == Stage::starting || stage == Stage::stimulus || stage == Stage::answering;
}

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
    std::vector<const pattern::Pattern*> stimuli;
    for (const study::StudyPattern& pattern : task.patterns) {
        const std::string id = study::stimulusId(task, pattern, task.conditions[plan.condition]);
        stimuli.push_back(set.find(id));
        if (stimuli.back() == nullptr)
            return core::Unexpected(core::Error{
                core::ErrorKind::notFound,
                tr("there is no pattern \"%1\" to be felt").arg(QString::fromStdString(id)).toStdString(),
                tr("a protocol that names a file for each pattern that does not come with the program")
                    .toStdString(),
                {}});
    }
    core::Expected<study::Session> session = study::Session::create(protocol, plan, kept, began_ns);
    if (!session)
        return core::Unexpected(session.error());
    clear();
    m_output = &output;
    m_session = std::move(*session);
    m_set = set;
    m_stimuli = std::move(stimuli);
    m_stimulus_s = protocol.stimulus_s;
    m_rest = protocol.rest;
    m_results.assign(kept.begin(), kept.end());
    // Whoever was interrupted has rested.
    m_rested = progress();
    settle();
    emit changed();
    return {};
}

void StudyRunner::clear() {
    ++m_run;
    m_timer.stop();
    if (m_session && m_output != nullptr && isRunning(m_session->stage()))
        m_output->stop();
    m_session.reset();
    m_output = nullptr;
    m_results.clear();
    m_hold = Hold::none;
    m_reason.clear();
    m_pauseWanted = m_nextWanted = m_keeping = m_concluded = m_testBegun = false;
    emit changed();
}

void StudyRunner::next(std::int64_t time_ns) {
    poll();
    if (!m_session)
        return;
    letPass(time_ns);
    if (m_hold == Hold::rest && time_ns >= m_restUntil_ns) {
        m_hold = Hold::none;
        m_session->goOn();
    }
    if (m_hold != Hold::none)
        return;
    if (m_session->stage() == Stage::feedback) {
        m_session->feedbackSeen();
        settle();
    }
    if (m_hold == Hold::none && m_session->stage() == Stage::ready) {
        if (m_keeping)
            m_nextWanted = true;
        else
            beginStimulus(time_ns);
    }
    emit changed();
}

void StudyRunner::beginStimulus(std::int64_t time_ns) {
    m_nextWanted = false;
    if (const QString obstacle = m_output->obstacle(); !obstacle.isEmpty()) {
        hold(m_stop.engaged() ? Hold::stopped : Hold::deviceLost, obstacle);
        return;
    }
    if (!m_session->startTrial(time_ns))
        return;
    showStimulus(time_ns);
    m_timer.start();
}

void StudyRunner::showStimulus(std::int64_t time_ns) {
    if (const study::PlannedTrial* trial = m_session->current())
        m_output->begin(*m_stimuli[trial->stimulus], m_stimulus_s, time_ns);
}

void StudyRunner::replay(std::int64_t time_ns) {
    if (!m_session)
        return;
    poll();
    if (m_hold == Hold::none && m_session->replay(time_ns))
        showStimulus(time_ns);
    emit changed();
}

void StudyRunner::press(const study::KeyPress& press) {
    if (!m_session)
        return;
    // What happened to the stimulus before the press belongs before it, and what happened after it behind.
    follow(press.time_ns);
    m_session->press(press);
    settle();
    emit changed();
}

void StudyRunner::release(const std::string& device, const std::string& key) {
    if (m_session)
        m_session->release(device, key);
}

void StudyRunner::follow(std::int64_t until_ns) {
    if (m_session->stage() != Stage::starting && m_session->stage() != Stage::stimulus)
        return;
    const StimulusState state = m_output->state(until_ns);
    if (m_session->stage() == Stage::starting && state.onset_ns != 0 && state.onset_ns <= until_ns)
        m_session->stimulusStarted(state.onset_ns,
                                   state.due_ns != 0 ? std::optional(state.due_ns) : std::nullopt);
    if (!state.failure.isEmpty())
        fail(state.failure, m_stop.engaged() ? Hold::stopped : Hold::deviceLost, until_ns);
    else if (m_session->stage() == Stage::stimulus && state.end_ns != 0 && state.end_ns <= until_ns)
        m_session->stimulusEnded(state.end_ns);
}

void StudyRunner::fail(const QString& reason, Hold why, std::int64_t time_ns) {
    m_output->stop();
    m_session->deviceFailed(time_ns);
    hold(why, reason);
    settle();
}

void StudyRunner::poll() {
    if (!m_session)
        return;
    const Stage stage = m_session->stage();
    const Hold held = m_hold;
    const std::int64_t now_ns = m_clock();
    if (isRunning(stage)) {
        follow(now_ns);
        if (m_stop.engaged() && isRunning(m_session->stage()))
            fail(tr("STOP was pressed"), Hold::stopped, now_ns);
        settle();
    } else if (m_stop.engaged() && !waitsForExperimenter() && !m_concluded) {
        hold(Hold::stopped, tr("STOP was pressed"));
    }
    if (m_session && (stage != m_session->stage() || held != m_hold))
        emit changed();
}

void StudyRunner::turn() {
    poll();
    const std::optional<std::int64_t> deadline = m_session ? m_session->deadline_ns() : std::nullopt;
    const std::int64_t now_ns = m_clock();
    if (!deadline || now_ns <= *deadline)
        m_turnsLate = 0;
    else if (++m_turnsLate > kTurnsForInput)
        letPass(now_ns);
}

/// Everything that was done before this time must have been handled.
void StudyRunner::letPass(std::int64_t time_ns) {
    const Stage stage = m_session->stage();
    m_session->advance(time_ns);
    settle();
    if (m_session && stage != m_session->stage())
        emit changed();
}

bool StudyRunner::isPracticeOver() const {
    const study::PlannedTrial* current = m_session->current();
    return current != nullptr && current->phase == Phase::test && !m_results.empty() &&
           m_results.back().planned.phase == Phase::practice;
}

/// Of the phase that goes on: its completed trials.
std::pair<Phase, std::size_t> StudyRunner::progress() const {
    const study::PlannedTrial* current = m_session->current();
    const Phase phase = current == nullptr ? Phase::test : current->phase;
    return {phase, static_cast<std::size_t>(
                       std::count_if(m_results.begin(), m_results.end(), [phase](const auto& result) {
                           return result.planned.phase == phase && result.isComplete();
                       }))};
}

bool StudyRunner::isRestDue() const {
    const auto now = progress();
    return m_rest.isDueAfter(now.second) && now != m_rested;
}

double StudyRunner::restLeft_s() const {
    return m_hold == Hold::rest ? std::max(0.0, 1e-9 * static_cast<double>(m_restUntil_ns - m_clock())) : 0.0;
}

void StudyRunner::hold(Hold why, const QString& reason) {
    m_nextWanted = false;
    m_hold = why;
    m_reason = reason;
    // The session itself knows pauses between trials only; while feedback is shown nothing runs anyway.
    (void)m_session->pause();
}

void StudyRunner::settle() {
    if (!m_session)
        return;
    if (!isRunning(m_session->stage()))
        m_timer.stop();
    if (std::optional<study::TrialResult> result = m_session->takeResult()) {
        const StimulusState shown = m_output->state(m_clock());
        result->frameWrite_ms = shown.frameWrite_ms;
        result->framesMissed = shown.framesMissed;
        // The answer ends the stimulus.
        m_output->stop();
        m_results.push_back(*result);
        m_ended = m_utcNow();
        keep(*result);
        emit trialEnded(*result);
    }
    if (m_session->stage() == Stage::ready && m_hold == Hold::none) {
        if (isPracticeOver() && !m_testBegun)
            hold(Hold::blockEnd);
        else if (std::exchange(m_pauseWanted, false))
            hold(Hold::paused);
        else if (isRestDue()) {
            m_rested = progress();
            m_restUntil_ns = m_clock() + std::llround(1e9 * m_rest.atLeast_s);
            hold(Hold::rest);
        }
    }
    if (m_keeping || m_hold == Hold::notKept || m_concluded)
        return;
    if (m_session->stage() == Stage::finished) {
        m_concluded = true;
        emit blockKept(Phase::test);
        emit finished();
    } else if (m_session->stage() == Stage::aborted) {
        m_concluded = true;
        emit aborted();
    }
}

void StudyRunner::keep(const study::TrialResult& result) {
    m_keeping = true;
    m_keep(result, m_ended, [this, run = m_run](const core::Expected<void>& kept) {
        if (run != m_run)
            return;
        m_keeping = false;
        if (!kept) {
            m_waitsForServer = kept.error().kind == core::ErrorKind::unavailable;
            hold(Hold::notKept, QString::fromStdString(core::describe(kept.error())));
            emit changed();
            return;
        }
        const study::PlannedTrial* current = m_session->current();
        if (m_results.back().planned.phase == Phase::practice && m_results.back().isComplete() &&
            (current == nullptr || current->phase == Phase::test))
            emit blockKept(Phase::practice);
        settle();
        if (m_nextWanted && m_hold == Hold::none && m_session->stage() == Stage::ready)
            beginStimulus(m_clock());
        emit changed();
    });
}

void StudyRunner::pause() {
    if (!m_session || waitsForExperimenter() || m_concluded)
        return;
    if (m_session->stage() == Stage::ready || m_hold == Hold::rest)
        hold(Hold::paused);
    else
        m_pauseWanted = true;
    emit changed();
}

void StudyRunner::goOn() {
    if (!m_session || m_hold == Hold::notKept)
        return;
    m_pauseWanted = false;
    if (m_stop.engaged() || m_hold == Hold::none)
        return;
    if (const QString obstacle = m_output->obstacle(); !obstacle.isEmpty()) {
        hold(Hold::deviceLost, obstacle);
        emit changed();
        return;
    }
    m_hold = Hold::none;
    m_reason.clear();
    m_session->goOn();
    // Whoever had to wait has rested.
    m_rested = progress();
    // Whatever held it there, the experimenter has let the test begin.
    m_testBegun = m_session->stage() == Stage::ready && isPracticeOver();
    emit changed();
}

void StudyRunner::abort() {
    if (!m_session || m_concluded)
        return;
    m_output->stop();
    m_session->abort(m_clock());
    if (m_hold != Hold::notKept)
        m_hold = Hold::none;
    settle();
    emit changed();
}

void StudyRunner::retry() {
    if (!m_session || m_hold != Hold::notKept || m_results.empty())
        return;
    const Stage stage = m_session->stage();
    m_hold = stage == Stage::finished || stage == Stage::aborted ? Hold::none : Hold::paused;
    m_reason.clear();
    keep(m_results.back());
    emit changed();
}

} // namespace teleta::console
