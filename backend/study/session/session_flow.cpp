// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/session_flow.h"

#include <algorithm>
#include <cmath>

namespace teleta::study {

core::Expected<SessionFlow> SessionFlow::create(const Protocol& protocol, const PlannedSession& plan,
                                                std::span<const TrialResult> done, std::int64_t began_ns) {
    TELETA_TRY(Session session, Session::create(protocol, plan, done, began_ns));
    SessionFlow flow(std::move(session));
    flow.m_rest = protocol.rest;
    flow.m_results.assign(done.begin(), done.end());
    return flow;
}

bool SessionFlow::isPracticeOver() const {
    const PlannedTrial* current = m_session.current();
    return current != nullptr && current->phase == Phase::test && !m_results.empty() &&
           m_results.back().planned.phase == Phase::practice;
}

bool SessionFlow::isPracticeKept() const {
    return m_last == Last::kept && !m_results.empty() && m_results.back().planned.phase == Phase::practice &&
           (m_session.current() == nullptr || isPracticeOver());
}

bool SessionFlow::isOver() const {
    const Stage stage = m_session.stage();
    return m_last == Last::kept && (stage == Stage::finished || stage == Stage::aborted);
}

SessionFlow::Progress SessionFlow::progress() const {
    const PlannedTrial* current = m_session.current();
    const Phase phase = current == nullptr ? Phase::test : current->phase;
    return {phase, static_cast<std::size_t>(std::ranges::count_if(m_results, [phase](const auto& result) {
                return result.planned.phase == phase && result.isComplete();
            }))};
}

void SessionFlow::countAsRest() {
    if (!isPracticeOver())
        m_passed = progress();
}

void SessionFlow::next(std::int64_t time_ns) {
    if (m_hold == Hold::rest && time_ns >= m_restUntil_ns)
        goOn();
    if (m_hold != Hold::none)
        return;
    if (m_session.stage() == Stage::feedback) {
        m_session.feedbackSeen();
        settle(time_ns);
    }
    if (m_hold == Hold::none && m_session.stage() == Stage::ready)
        m_wish = Wish::next;
}

bool SessionFlow::isTrialDue() const {
    return m_wish == Wish::next && m_hold == Hold::none && m_last == Last::kept &&
           m_session.stage() == Stage::ready;
}

bool SessionFlow::startTrial(std::int64_t time_ns) {
    if (!isTrialDue())
        return false;
    m_wish = Wish::none;
    return m_session.startTrial(time_ns);
}

void SessionFlow::keeping(TrialResult result) {
    m_results.push_back(std::move(result));
    m_last = Last::keeping;
}

void SessionFlow::kept(const core::Expected<void>& outcome) {
    if (outcome) {
        m_last = Last::kept;
        return;
    }
    m_last = outcome.error().kind == core::ErrorKind::unavailable ? Last::waitsForServer : Last::notKept;
    holdBack(Hold::notKept, core::describe(outcome.error()));
}

void SessionFlow::settle(std::int64_t now_ns) {
    if (m_session.stage() != Stage::ready || m_hold != Hold::none)
        return;
    const bool isNew = m_passed != progress();
    if (isNew && isPracticeOver()) {
        holdBack(Hold::blockEnd);
    } else if (m_wish == Wish::pause) {
        holdBack(Hold::paused);
    } else if (isNew && m_rest.isDueAfter(progress().second)) {
        m_restUntil_ns = now_ns + std::llround(1e9 * m_rest.atLeast_s);
        holdBack(Hold::rest);
    }
}

void SessionFlow::holdBack(Hold why, std::string reason) {
    m_wish = Wish::none;
    m_hold = why;
    m_reason = std::move(reason);
    // Only a session that is ready can pause; while feedback is shown nothing runs anyway.
    (void)m_session.pause();
}

void SessionFlow::pause() {
    if (waitsForExperimenter() || isOver())
        return;
    if (m_session.stage() == Stage::ready || m_hold == Hold::rest)
        holdBack(Hold::paused);
    else
        m_wish = Wish::pause;
}

void SessionFlow::goOn() {
    if (m_hold == Hold::notKept)
        return;
    if (m_wish == Wish::pause)
        m_wish = Wish::none;
    if (m_hold == Hold::none)
        return;
    m_hold = Hold::none;
    m_reason.clear();
    m_session.goOn();
    // Whatever held the session counts as a rest, and going on after the practice begins the test.
    if (m_session.stage() == Stage::ready)
        m_passed = progress();
    else
        countAsRest();
}

void SessionFlow::abort(std::int64_t time_ns) {
    m_session.abort(time_ns);
    if (m_hold != Hold::notKept)
        m_hold = Hold::none;
}

void SessionFlow::retry() {
    if (m_hold != Hold::notKept)
        return;
    const Stage stage = m_session.stage();
    m_hold = stage == Stage::finished || stage == Stage::aborted ? Hold::none : Hold::paused;
    m_reason.clear();
    m_last = Last::keeping;
}

} // namespace teleta::study
