// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/stimulus_output.h"
#include "app/console/study/running/trial_observer.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/session/session_flow.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace teleta::console {

/// Runs one session: connects its rules (study::SessionFlow) to the participant's keys, the stimuli, STOP and
/// whatever keeps the results. Thread: GUI.
class StudyRunner : public QObject {
    Q_OBJECT

public:
    using Clock = std::function<std::int64_t()>;
    using WallClock = std::function<QDateTime()>; ///< UTC
    using Kept = std::function<void(const core::Expected<void>&)>;
    /// Keeps a result and calls back, on this thread, when it is safe or could not be kept. The time is the
    /// UTC at which the trial ended; retries have the same. Error: unavailable when the result is safe on
    /// this machine and waits for its server.
    using Keep = std::function<void(const study::TrialResult&, const QDateTime&, Kept)>;

    StudyRunner(const core::StopSwitch& stop, Clock clock, WallClock utcNow, Keep keep,
                QObject* parent = nullptr);

    /// Begins a session or, with the results kept before an interruption, resumes it. began_ns: when the
    /// session began, at most now. output: must outlive the session. Error: refused when the results are not
    /// those of this plan or a stimulus does not fit its levels, notFound when a stimulus has no pattern.
    [[nodiscard]] core::Expected<void> begin(StimulusOutput& output, const study::Protocol& protocol,
                                             const study::StimulusSet& stimuli,
                                             const study::PlannedSession& plan,
                                             std::span<const study::TrialResult> kept, std::int64_t began_ns);
    /// Who hears of the trials; null: nobody. Must outlive the runner or be taken back.
    void observe(TrialObserver* observer) { m_observer = observer; }
    /// Drops the session; a trial that runs is not kept and will be shown again.
    void clear();

    /// What the participant does, each with the time of its input event and in this order.
    void next(std::int64_t time_ns);
    void replay(std::int64_t time_ns);
    void press(const study::KeyPress& press);
    void release(const std::string& device, const std::string& key);

    /// What the experimenter does. A pause takes effect between trials.
    void pause();
    void goOn();
    void abort();
    void retry();

    /// Checks STOP and the device. While a trial runs the runner does so itself, and checks the time limit;
    /// between trials its user has to.
    void poll();

    [[nodiscard]] bool isActive() const { return m_flow.has_value(); }
    /// Null: no session.
    [[nodiscard]] const study::SessionFlow* flow() const;
    [[nodiscard]] const study::Session* session() const;
    [[nodiscard]] study::Hold hold() const { return m_flow ? m_flow->hold() : study::Hold::none; }
    [[nodiscard]] bool isKeeping() const { return m_flow && m_flow->isKeeping(); }
    /// Why it holds, in words, for stopped, deviceLost and notKept.
    [[nodiscard]] QString reason() const;
    /// The interval of the running trial that is felt now, from 1; 0: none, or the trial has only one.
    [[nodiscard]] std::size_t interval() const;
    /// Time left of a rest; 0 when the participant may go on.
    [[nodiscard]] double restLeft_s() const;

signals:
    void changed();
    /// All trials of a phase are kept.
    void blockKept();
    /// All results are kept, and no trial is left or the session was aborted. The session stays readable.
    void finished();
    void aborted();

private:
    void beginTrial(std::int64_t time_ns);
    void showStimulus(std::int64_t time_ns);
    void follow(std::int64_t until_ns);
    void fail(const QString& reason, study::Hold hold, std::int64_t time_ns);
    void turn();
    void letPass(std::int64_t time_ns);
    void settle();
    void keep();

    const core::StopSwitch& m_stop;
    Clock m_clock;
    WallClock m_utcNow;
    Keep m_keep;
    StimulusOutput* m_output = nullptr;
    TrialObserver* m_observer = nullptr;
    QTimer m_timer; ///< runs while a trial does

    std::optional<study::SessionFlow> m_flow;
    study::StimulusSet m_set;
    study::StudyTask m_task;
    std::string m_condition;
    /// Of the set: those of the session, of a task with levels the one that is varied.
    std::vector<const pattern::Pattern*> m_stimuli;
    double m_stimulus_s = 0.0;
    std::size_t m_interval = 0; ///< that was announced
    study::TrialResult m_last;  ///< that ended in this run of the session
    QDateTime m_ended;          ///< UTC: when it ended
    bool m_concluded = false;   ///< its end was announced
    int m_turnsLate = 0;        ///< since the limit
    std::uint64_t m_run = 0;    ///< distinguishes callbacks for this session from those for an earlier one
};

} // namespace teleta::console
