// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/level_sequence.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace teleta::study {

/// An answer key or button that went down.
struct KeyPress {
    std::optional<std::size_t> response; ///< the answer that it stands for; empty: none
    std::string device;                  ///< mouse, touch, keyboard, keypad, simulated
    std::string key;                     ///< physical key or button
    std::int64_t time_ns = 0;            ///< of the input event
    bool autoRepeat = false;
};

/// What a session waits for.
enum class Stage {
    ready,     ///< for the participant to ask for the next trial
    starting,  ///< for the stimulus to begin
    stimulus,  ///< for the stimulus to end, or an answer
    answering, ///< for an answer after the stimulus
    feedback,  ///< for the participant to have seen the right answer
    paused,    ///< for something between trials, see SessionFlow
    finished,
    aborted,
};

/// The trials of one participant's session: practice, then test, of one task under one condition. The caller
/// shows the stimulus and passes on what happens with its time on the steady clock; the session decides what
/// it means. What happens between trials is SessionFlow's.
/// Answers count from the onset (or the end, as the protocol says) until the limit, both ends included, by
/// the time of the press, even when it is reported later. Repeats of a held key, and keys still down from
/// before, do not count; other presses outside the window are early presses. A trial that ends by a device
/// fault or an abort is shown again at the end of its phase with attempt + 1, of a task with levels at once:
/// what comes next depends on its answer (LevelSequence).
/// Thread: one. Times must not go back, except those of presses.
class Session {
public:
    /// done: the results that were kept before an interruption, in their order; the session resumes after
    /// them. Error: refused when they are not results of this plan.
    [[nodiscard]] static core::Expected<Session> create(const Protocol& protocol, const PlannedSession& plan,
                                                        std::span<const TrialResult> done,
                                                        std::int64_t now_ns);

    [[nodiscard]] Stage stage() const { return m_stage; }
    /// A trial is being shown.
    [[nodiscard]] bool isRunning() const {
        return m_stage == Stage::starting || m_stage == Stage::stimulus || m_stage == Stage::answering;
    }

    /// The trial that is shown or comes next; nullptr when the session is over.
    [[nodiscard]] const PlannedTrial* current() const { return m_queue.empty() ? nullptr : &m_queue.front(); }

    /// Trials that are planned; of a task with levels only the next one is.
    [[nodiscard]] std::size_t remainingTrials() const { return m_queue.size(); }
    /// Without feedback where no answer is right.
    [[nodiscard]] const PhaseSettings& settings(Phase phase) const {
        return phase == Phase::practice ? m_practice : m_test;
    }

    /// When the time to answer ends; empty while it does not run.
    [[nodiscard]] std::optional<std::int64_t> deadline_ns() const;

    /// When the stimulus began that is felt now; empty: none is.
    [[nodiscard]] std::optional<std::int64_t> stimulusOnset_ns() const {
        return m_stage == Stage::stimulus ? std::optional(m_onset_ns) : std::nullopt;
    }

    /// Replays of the stimulus that are left in the running trial.
    [[nodiscard]] std::size_t replaysLeft() const {
        return isRunning() && m_trial.replays < m_replays ? m_replays - m_trial.replays : 0;
    }

    /// Starts the next trial. False, and nothing happens, unless ready and the last result has been taken.
    [[nodiscard]] bool startTrial(std::int64_t time_ns);

    /// due_ns: when the stimulus will end by itself, the reference for answers given before that; empty:
    /// after the protocol's stimulus time.
    void stimulusStarted(std::int64_t time_ns, std::optional<std::int64_t> due_ns = {});
    void stimulusEnded(std::int64_t time_ns);

    /// The participant wants to feel the stimulus again: back to starting. False unless it has ended and the
    /// protocol allows another replay.
    [[nodiscard]] bool replay(std::int64_t time_ns);

    void press(const KeyPress& press);
    void release(const std::string& device, const std::string& key);

    /// Times the trial out if its limit has passed. All input up to this time must have been passed on.
    void advance(std::int64_t time_ns);

    /// The device did not show the stimulus properly.
    void deviceFailed(std::int64_t time_ns);

    /// Ends the feedback.
    void feedbackSeen();

    /// Only between trials; false otherwise.
    [[nodiscard]] bool pause();
    void goOn();

    /// Ends the session; a running trial is aborted.
    void abort(std::int64_t time_ns);

    /// The result of the trial that has just ended, once.
    [[nodiscard]] std::optional<TrialResult> takeResult();

private:
    Session(const Protocol& protocol, const PlannedSession& plan, std::int64_t now_ns);

    [[nodiscard]] bool windowIsOpen() const;
    [[nodiscard]] bool windowIsOpenAt(std::int64_t time_ns) const;
    void complete(Outcome outcome, std::int64_t time_ns);
    void showAgain(PlannedTrial trial);
    void goOnAfter(const TrialResult& result);

    std::int64_t m_stimulus_ns;
    std::int64_t m_limit_ns;
    ResponseWindow m_window;
    std::size_t m_replays;
    PhaseSettings m_practice;
    PhaseSettings m_test;

    std::deque<PlannedTrial> m_queue;
    std::optional<LevelSequence> m_levels; ///< of a task with levels: what comes after the queue
    std::size_t m_shown[2] = {0, 0};       ///< trials of each phase that were shown to their end
    Stage m_stage = Stage::ready;
    std::int64_t m_begin_ns;
    std::int64_t m_request_ns = 0;
    std::int64_t m_onset_ns = 0;
    std::int64_t m_due_ns = 0;
    std::optional<std::int64_t> m_end_ns;
    TrialResult m_trial; ///< of the current trial, as far as it is known
    std::set<std::string> m_held;
    std::optional<TrialResult> m_result;
};

} // namespace teleta::study
