// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/session.h"

#include "backend/core/failure.h"
#include "backend/study/protocol/trial_pattern.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::study {

namespace {

struct SessionText {
    Q_DECLARE_TR_FUNCTIONS(StudySession)
};

std::int64_t nanoseconds(double time_s) {
    return std::llround(time_s * 1e9);
}

double seconds(std::int64_t time_ns) {
    return static_cast<double>(time_ns) / 1e9;
}

void append(std::deque<PlannedTrial>& queue, Phase phase, const std::vector<std::size_t>& stimuli) {
    for (std::size_t i = 0; i < stimuli.size(); ++i) {
        const auto until = stimuli.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        const auto repetition = std::count(stimuli.begin(), until, stimuli[i]);
        queue.push_back({phase, i + 1, static_cast<std::size_t>(repetition), 1, stimuli[i]});
    }
}

/// Whether a stored trial is the one that the plan has now. Levels come back from text or a database.
bool isSame(const PlannedTrial& planned, const PlannedTrial& stored) {
    constexpr double kRounding = 1e-9;
    return planned.phase == stored.phase && planned.trial == stored.trial &&
           planned.attempt == stored.attempt && planned.stimulus == stored.stimulus &&
           planned.track == stored.track && planned.target == stored.target &&
           planned.level.has_value() == stored.level.has_value() &&
           std::abs(planned.level.value_or(0.0) - stored.level.value_or(0.0)) <=
               kRounding * std::abs(planned.level.value_or(0.0));
}

} // namespace

Session::Session(const Protocol& protocol, const PlannedSession& plan, std::int64_t now_ns)
    : m_stimulus_ns(nanoseconds(protocol.stimulus_s))
    , m_limit_ns(nanoseconds(protocol.responseLimit_s))
    , m_window(protocol.window)
    , m_replays(protocol.replays)
    , m_practice(protocol.practice)
    , m_test(protocol.test)
    , m_begin_ns(now_ns) {
    const StudyTask& task = protocol.tasks[plan.task];
    if (task.design == Design::identification) {
        append(m_queue, Phase::practice, plan.practice);
        append(m_queue, Phase::test, plan.test);
        return;
    }
    m_stimulus_ns = nanoseconds(trialLength_s(task, protocol.stimulus_s));
    if (task.design == Design::compare)
        m_practice.feedback = m_test.feedback = false;
    m_levels.emplace(protocol, plan);
    if (const auto first = m_levels->next())
        m_queue.push_back(*first);
}

core::Expected<Session> Session::create(const Protocol& protocol, const PlannedSession& plan,
                                        std::span<const TrialResult> done, std::int64_t now_ns) {
    Session session(protocol, plan, now_ns);
    for (const TrialResult& result : done) {
        const PlannedTrial* next = session.current();
        if (next == nullptr || !isSame(*next, result.planned))
            return core::refused(SessionText::tr("the stored trials do not belong to this session's plan"),
                                 SessionText::tr("the order given by the session's seed"));
        session.m_queue.pop_front();
        ++session.m_shown[static_cast<int>(result.planned.phase)];
        session.goOnAfter(result);
    }
    if (session.m_queue.empty())
        session.m_stage = Stage::finished;
    return session;
}

/// Requeues the trial at the end of its phase.
void Session::showAgain(PlannedTrial trial) {
    ++trial.attempt;
    const auto next =
        std::ranges::find_if(m_queue, [&](const PlannedTrial& other) { return other.phase > trial.phase; });
    m_queue.insert(next, trial);
}

/// Plans what follows a trial that has left the queue.
void Session::goOnAfter(const TrialResult& result) {
    if (m_levels) {
        m_levels->take(result);
        if (const auto next = m_levels->next())
            m_queue.push_back(*next);
    } else if (!result.isComplete()) {
        showAgain(result.planned);
    }
}

bool Session::windowIsOpen() const {
    return m_stage == Stage::answering ||
           (m_stage == Stage::stimulus && m_window == ResponseWindow::fromOnset);
}

/// The window may be open now and yet have been closed at this time.
bool Session::windowIsOpenAt(std::int64_t time_ns) const {
    return windowIsOpen() && time_ns >= (m_window == ResponseWindow::fromOnset ? m_onset_ns : *m_end_ns);
}

std::optional<std::int64_t> Session::deadline_ns() const {
    if (!windowIsOpen())
        return std::nullopt;
    return (m_window == ResponseWindow::fromOnset ? m_onset_ns : *m_end_ns) + m_limit_ns;
}

bool Session::startTrial(std::int64_t time_ns) {
    if (m_stage != Stage::ready || m_result)
        return false;
    const std::size_t earlyPresses = m_trial.earlyPresses;
    m_trial = {};
    m_trial.planned = m_queue.front();
    m_trial.earlyPresses = earlyPresses;
    m_request_ns = time_ns;
    m_onset_ns = time_ns;
    m_end_ns.reset();
    m_stage = Stage::starting;
    return true;
}

void Session::stimulusStarted(std::int64_t time_ns, std::optional<std::int64_t> due_ns) {
    if (m_stage != Stage::starting)
        return;
    m_onset_ns = time_ns;
    m_due_ns = due_ns.value_or(time_ns + m_stimulus_ns);
    m_trial.deviceLatency_ms = seconds(time_ns - m_request_ns) * 1e3;
    m_stage = Stage::stimulus;
}

void Session::stimulusEnded(std::int64_t time_ns) {
    if (m_stage != Stage::stimulus)
        return;
    m_end_ns = time_ns;
    m_stage = Stage::answering;
}

bool Session::replay(std::int64_t time_ns) {
    advance(time_ns);
    if (m_stage != Stage::answering || m_trial.replays >= m_replays)
        return false;
    ++m_trial.replays;
    m_request_ns = time_ns;
    m_end_ns.reset();
    m_stage = Stage::starting;
    return true;
}

void Session::press(const KeyPress& press) {
    if (press.autoRepeat || !m_held.insert(press.device + '/' + press.key).second || !press.response)
        return;
    const bool wasOpen = windowIsOpen();
    advance(press.time_ns);
    if (!windowIsOpenAt(press.time_ns)) {
        // A press after the limit is late, not early for the next trial.
        if ((!wasOpen || windowIsOpen()) && (m_stage == Stage::ready || isRunning()))
            ++m_trial.earlyPresses;
        return;
    }
    m_trial.response = press.response;
    m_trial.responseDevice = press.device;
    m_trial.responseKey = press.key;
    m_trial.responseTime_s = seconds(press.time_ns - m_onset_ns);
    m_trial.responseTimeOffset_s = seconds(press.time_ns - m_end_ns.value_or(m_due_ns));
    complete(*press.response == m_trial.planned.stimulus ? Outcome::correct : Outcome::incorrect,
             press.time_ns);
}

void Session::release(const std::string& device, const std::string& key) {
    m_held.erase(device + '/' + key);
}

void Session::advance(std::int64_t time_ns) {
    const std::optional<std::int64_t> deadline = deadline_ns();
    if (deadline && time_ns > *deadline)
        complete(Outcome::timeout, *deadline);
}

void Session::deviceFailed(std::int64_t time_ns) {
    if (!isRunning())
        return;
    ++m_trial.deviceFaults;
    complete(Outcome::deviceError, time_ns);
}

void Session::feedbackSeen() {
    if (m_stage == Stage::feedback)
        m_stage = m_queue.empty() ? Stage::finished : Stage::ready;
}

bool Session::pause() {
    if (m_stage != Stage::ready)
        return false;
    m_stage = Stage::paused;
    return true;
}

void Session::goOn() {
    if (m_stage == Stage::paused)
        m_stage = Stage::ready;
}

void Session::abort(std::int64_t time_ns) {
    if (m_stage == Stage::finished)
        return;
    if (isRunning())
        complete(Outcome::aborted, time_ns);
    m_stage = Stage::aborted;
}

std::optional<TrialResult> Session::takeResult() {
    return std::exchange(m_result, std::nullopt);
}

void Session::complete(Outcome outcome, std::int64_t time_ns) {
    m_queue.pop_front();
    m_trial.outcome = outcome;
    m_trial.onset_s = seconds(m_onset_ns - m_begin_ns);
    m_trial.duration_s = m_stage == Stage::starting ? 0.0 : seconds(m_end_ns.value_or(time_ns) - m_onset_ns);
    m_trial.trialInBlock = ++m_shown[static_cast<int>(m_trial.planned.phase)];
    goOnAfter(m_trial);
    m_result = m_trial;
    m_trial = {};
    if (m_result->isComplete() && settings(m_result->planned.phase).feedback)
        m_stage = Stage::feedback;
    else
        m_stage = m_queue.empty() ? Stage::finished : Stage::ready;
}

} // namespace teleta::study
