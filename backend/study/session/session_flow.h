// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/session/session.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::study {

/// Why a session does not go on by itself.
enum class Hold {
    none,
    paused,     ///< by the experimenter
    rest,       ///< the protocol has a rest here; the participant goes on after its time
    blockEnd,   ///< practice is over; the test begins when the experimenter says so
    stopped,    ///< STOP
    deviceLost, ///< the stimulus could not be shown properly
    notKept,    ///< the last result could not be kept; retry() tries again
};

/// What happens between the trials of a session: pauses, rests, the end of practice, and keeping each result
/// before the next trial may start. Sessions with people and rehearsals follow the same rules.
/// The caller owns the clock, the stimulus and the store. It passes on what happens; whenever something has
/// happened it takes the result that there may be, gives it to the store, and calls settle():
///   takeResult() -> keeping(result) -> settle() -> kept(outcome), which may come later.
/// Thread: one. Times must not go back, except those of presses.
class SessionFlow {
public:
    /// done: the results that were kept before an interruption, in their order. Error: as Session::create().
    [[nodiscard]] static core::Expected<SessionFlow> create(const Protocol& protocol,
                                                            const PlannedSession& plan,
                                                            std::span<const TrialResult> done,
                                                            std::int64_t began_ns);

    [[nodiscard]] const Session& session() const { return m_session; }
    /// The trial at hand: onset, end, presses, faults.
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] Hold hold() const { return m_hold; }
    /// Why it holds, in words, for stopped, deviceLost and notKept.
    [[nodiscard]] const std::string& reason() const { return m_reason; }
    /// The next step is the experimenter's, not the participant's.
    [[nodiscard]] bool waitsForExperimenter() const { return m_hold != Hold::none && m_hold != Hold::rest; }
    /// A pause follows the trial at hand.
    [[nodiscard]] bool pauseWanted() const { return m_wish == Wish::pause; }
    /// When the participant may end the rest; meaningful for Hold::rest.
    [[nodiscard]] std::int64_t restUntil_ns() const { return m_restUntil_ns; }
    /// Results of this session in their order, including those that were kept before.
    [[nodiscard]] const std::vector<TrialResult>& results() const { return m_results; }
    [[nodiscard]] bool isKeeping() const { return m_last == Last::keeping; }
    /// Of notKept: the result is safe on this machine, and is sent when the server is back.
    [[nodiscard]] bool waitsForServer() const { return m_last == Last::waitsForServer; }
    /// The practice is complete, the test not begun, and all results are kept.
    [[nodiscard]] bool isPracticeKept() const;
    /// Finished or aborted, and all results are kept.
    [[nodiscard]] bool isOver() const;

    /// The participant has seen the feedback or has rested, and wants the next trial, which starts as soon as
    /// nothing holds the session: see startTrial().
    void next(std::int64_t time_ns);
    /// The trial that the participant has asked for starts now. False: there is none, or it must not start.
    [[nodiscard]] bool startTrial(std::int64_t time_ns);
    /// The participant has asked for the next trial, and nothing is in its way.
    [[nodiscard]] bool isTrialDue() const;

    /// The result of the trial that has just ended, once. The caller completes it and calls keeping().
    [[nodiscard]] std::optional<TrialResult> takeResult() { return m_session.takeResult(); }
    /// The result is on its way to the store.
    void keeping(TrialResult result);
    /// What became of it.
    void kept(const core::Expected<void>& outcome);
    /// Between trials: holds the session where the protocol or the experimenter wants it.
    void settle(std::int64_t now_ns);

    /// A pause takes effect between trials.
    void pause();
    void holdBack(Hold why, std::string reason = {});
    /// The experimenter lets the session go on; not from notKept.
    void goOn();
    void abort(std::int64_t time_ns);
    /// After notKept: the last result is on its way to the store once more.
    void retry();
    /// The time since the last result counts as a rest, an interruption for example.
    void countAsRest();

private:
    enum class Wish { none, pause, next };
    enum class Last { kept, keeping, notKept, waitsForServer };
    using Progress = std::pair<Phase, std::size_t>; ///< completed trials of the phase that goes on

    explicit SessionFlow(Session session)
        : m_session(std::move(session)) {}
    [[nodiscard]] Progress progress() const;
    [[nodiscard]] bool isPracticeOver() const;

    Session m_session;
    RestSettings m_rest;
    std::vector<TrialResult> m_results;
    Hold m_hold = Hold::none;
    std::string m_reason;
    Wish m_wish = Wish::none;
    Last m_last = Last::kept; ///< of the results
    std::int64_t m_restUntil_ns = 0;
    std::optional<Progress> m_passed; ///< where a rest or the end of practice has been
};

} // namespace teleta::study
