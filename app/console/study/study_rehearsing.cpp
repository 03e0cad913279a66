// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated participants.
#include "app/console/study/study_controller.h"
#include "backend/study/protocol/trial_pattern.h"
#include "backend/study/session/simulated_observer.h"

#include <QCoreApplication>

#include <algorithm>

namespace teleta::console {

void StudyController::setSpeed(double speed) {
    if (speed == m_speed || isActive())
        return;
    m_anchor_ns = m_clock();
    m_speed = speed;
    m_questionnaires.setSpeed(speed);
    m_person.setSpeed(speed);
    emit changed();
}

void StudyController::openScene(const QString& folder, const study::StudyScene& scene, std::uint64_t seed) {
    if (!isActive() && !isBusy()) {
        m_scene = scene;
        m_sceneFolder = folder.toStdString();
    }
    study::StudyHead head;
    head.protocol = scene.protocol;
    head.seed = seed;
    head.mode = study::Mode::simulated;
    head.plannedParticipants = scene.participants;
    head.lapses = scene.lapses.value_or(0.0);
    head.created = m_utcNow();
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    openOrCreate(folder.toStdString(), head);
}

SimulatedPerson::Answers StudyController::simulatedAnswers(const study::StudyTask& task,
                                                           const std::string& condition) const {
    const study::StudyHead& head = m_overview->head;
    if (task.design == study::Design::identification) {
        const study::SimulatedParticipant person =
            m_scene ? m_scene->participantFor(task, condition)
                    : study::SimulatedParticipant{knownMatrix(task, condition), head.lapses};
        return [person](const study::PlannedTrial& trial, std::uint64_t seed) {
            return person.answer(trial.stimulus, seed);
        };
    }
    // An observer that cannot be read was never written.
    const auto observer = study::SimulatedObserver::parse(head.observer).value_or(study::SimulatedObserver());
    const study::PsychometricFunction function = observer.functionOf(
        task, condition, study::observerSeed(head.seed, m_running->participant.enrolment));
    const study::SimulatedParticipant times{std::nullopt, head.lapses,
                                            study::SimulatedObserver::kMedianResponse_s};
    const double length_s = study::trialLength_s(task, head.protocol.stimulus_s);
    return [=](const study::PlannedTrial& trial, std::uint64_t seed) {
        study::SimulatedParticipant::Answer answer{std::nullopt, length_s + times.time_s(seed)};
        if (!times.isLapse(seed))
            answer.response = study::SimulatedObserver::answer(function, task, trial, seed);
        return answer;
    };
}

void StudyController::startRehearsal() {
    if (!isSimulated() || m_rehearsing)
        return;
    m_rehearsing = true;
    if (m_runner.isActive())
        m_runner.goOn();
    else if (!isActive())
        refresh();
    emit changed();
}

void StudyController::stopRehearsal() {
    m_rehearsing = false;
}

/// Starts the next unfinished session of any participant; if there is none, enrols the next participant.
void StudyController::goOnRehearsing() {
    if (!m_rehearsing || isBusy() || m_questionnaires.current() != nullptr)
        return;
    forgetSession();
    const std::vector<ParticipantOverview>& people = m_overview->participants;
    for (std::size_t p = 0; p < people.size(); ++p) {
        if (const std::optional<std::size_t> session = people[p].nextSession()) {
            m_chosen = {static_cast<int>(p), static_cast<int>(*session)};
            lookAround(true);
            return;
        }
    }
    if (people.size() < std::max<std::size_t>(m_overview->head.plannedParticipants, 1)) {
        enrol(QStringLiteral("P%1").arg(people.size() + 1, 2, 10, QLatin1Char('0')));
        return;
    }
    m_rehearsing = false;
    emit rehearsed();
}

void StudyController::followSimulated() {
    // A rehearsal starts the test by itself.
    if (isSimulated() && m_runner.hold() == study::Hold::blockEnd && !m_runner.isKeeping())
        QMetaObject::invokeMethod(&m_runner, &StudyRunner::goOn, Qt::QueuedConnection);
}

} // namespace teleta::console
