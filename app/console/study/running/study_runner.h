// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/stimulus_output.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/study/protocol/stimulus_set.h"
#include "backend/study/session/session.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace teleta::console {

/// Runs one session: joins the session's rules with the participant's input, the stimuli and whatever keeps
/// the results. Nothing that a participant did is shown as done before it is safe: the next trial begins only
/// when the last one has been kept. Thread: GUI.
class StudyRunner : public QObject {
    Q_OBJECT

public:
    using Clock = std::function<std::int64_t()>;
    using WallClock = std::function<QDateTime()>; ///< UTC
    using Kept = std::function<void(const core::Expected<void>&)>;
    /// Keeps a result and calls back, on this thread, when it is safe or could not be kept. The time is the
    /// UTC of the trial's end: it is the same however often the result has to be kept. Error: unavailable
    /// when the result is safe here and waits for its server.
    using Keep = std::function<void(const study::TrialResult&, const QDateTime&, Kept)>;

    /// Why the session does not go on by itself.
    enum class Hold {
        none,
        paused,     ///< by the experimenter
        rest,       ///< the protocol has one here; the participant goes on after its time
        blockEnd,   ///< practice is over, the test begins when the experimenter says so
        stopped,    ///< STOP
        deviceLost, ///< the stimulus could not be shown as it should
        notKept,    ///< the last result could not be kept; retry() tries again
    };

    StudyRunner(const core::StopSwitch& stop, Clock clock, WallClock utcNow, Keep keep,
                QObject* parent = nullptr);

    /// Begins or, with what was kept, goes on. began_ns: when the session began, at most now. Error: refused
    /// when what was kept does not fit, notFound when a stimulus has no pattern. output: must outlive the
    /// session.
    [[nodiscard]] core::Expected<void> begin(StimulusOutput& output, const study::Protocol& protocol,
                                             const study::StimulusSet& stimuli,
                                             const study::PlannedSession& plan,
                                             std::span<const study::TrialResult> kept, std::int64_t began_ns);
    /// Forgets the session; a trial that runs is not kept and will be shown again.
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

    /// Looks at STOP and device. By itself while a trial runs, and then at its limit too; otherwise whoever
    /// shows it.
    void poll();

    [[nodiscard]] bool isActive() const { return m_session.has_value(); }
    [[nodiscard]] const study::Session* session() const { return m_session ? &*m_session : nullptr; }
    [[nodiscard]] Hold hold() const { return m_hold; }
    [[nodiscard]] bool pauseWanted() const { return m_pauseWanted; }
    [[nodiscard]] bool isKeeping() const { return m_keeping; }
    /// Of notKept: it is safe here, and is sent when the server is back or with the next start.
    [[nodiscard]] bool waitsForServer() const { return m_hold == Hold::notKept && m_waitsForServer; }
    /// Why it holds, in words, for deviceLost and notKept.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    /// Results of this session in their order, those that were kept before too.
    [[nodiscard]] const std::vector<study::TrialResult>& results() const { return m_results; }
    /// The next step is the experimenter's, not the participant's.
    [[nodiscard]] bool waitsForExperimenter() const { return m_hold != Hold::none && m_hold != Hold::rest; }
    /// Of a rest, until the participant may go on; 0 when that is now.
    [[nodiscard]] double restLeft_s() const;

signals:
    void changed();
    /// A trial was completed, or interrupted.
    void trialEnded(const teleta::study::TrialResult& result);
    /// All trials of a phase are kept.
    void blockKept(teleta::study::Phase phase);
    /// All trials are kept, or the session was aborted. The session can still be looked at.
    void finished();
    void aborted();

private:
    void beginStimulus(std::int64_t time_ns);
    void showStimulus(std::int64_t time_ns);
    void follow(std::int64_t until_ns);
    void fail(const QString& reason, Hold hold, std::int64_t time_ns);
    void turn();
    void letPass(std::int64_t time_ns);
    [[nodiscard]] bool isPracticeOver() const;
    [[nodiscard]] std::pair<study::Phase, std::size_t> progress() const;
    [[nodiscard]] bool isRestDue() const;
    void settle();
    void keep(const study::TrialResult& result);
    void hold(Hold hold, const QString& reason = {});

    const core::StopSwitch& m_stop;
    Clock m_clock;
    WallClock m_utcNow;
    Keep m_keep;
    StimulusOutput* m_output = nullptr;
    QTimer m_timer; ///< runs while a trial does

    std::optional<study::Session> m_session;
    study::StimulusSet m_set;
    std::vector<const pattern::Pattern*> m_stimuli; ///< of the set, those of the session
    double m_stimulus_s = 0.0;
    study::RestSettings m_rest;
    std::pair<study::Phase, std::size_t> m_rested; ///< progress() at the last rest
    std::int64_t m_restUntil_ns = 0;
    std::vector<study::TrialResult> m_results;
    QDateTime m_ended; ///< UTC: when the last of them ended, of this run of the session
    Hold m_hold = Hold::none;
    QString m_reason;
    bool m_pauseWanted = false;
    bool m_nextWanted = false; ///< asked for while the last result was being kept
    bool m_keeping = false;
    bool m_waitsForServer = false; ///< the last result that was not kept
    bool m_concluded = false;
    bool m_testBegun = false; ///< the experimenter let the test follow the practice
    int m_turnsLate = 0;      ///< since the limit
    std::uint64_t m_run = 0;  ///< tells the answers of this session's keeper from those of an earlier one
};

} // namespace teleta::console
