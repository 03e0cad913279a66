// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/study_runner.h"
#include "backend/study/session/simulated_participant.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>

namespace teleta::console {

/// Takes a participant's place: asks for trials, waits and answers, by the same calls as a person's keys.
/// The answers depend on the session's seed and the trial alone. Thread: GUI.
class SimulatedPerson : public QObject {
    Q_OBJECT

public:
    /// speed: how much faster the clock runs than the steady clock, > 0.
    SimulatedPerson(StudyRunner& runner, StudyRunner::Clock clock, double speed, QObject* parent = nullptr);

    /// How one person answers to a trial. seed: answerSeed() of the trial; the answer's time counts from the
    /// onset.
    using Answers =
        std::function<study::SimulatedParticipant::Answer(const study::PlannedTrial&, std::uint64_t seed)>;

    /// For the runner's session.
    void begin(Answers answers, std::uint64_t sessionSeed);
    void setSpeed(double speed) { m_speed = speed; }
    void leave();

private:
    void look();
    void act();

    StudyRunner& m_runner;
    StudyRunner::Clock m_clock;
    double m_speed;
    QTimer m_timer;
    Answers m_answers;
    std::uint64_t m_seed = 0;
    bool m_present = false;
    std::optional<study::SimulatedParticipant::Answer> m_answer; ///< to the trial that runs
};

} // namespace teleta::console
