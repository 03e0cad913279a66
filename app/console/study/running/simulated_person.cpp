// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/simulated_person.h"

#include "backend/study/protocol/trial_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::Stage;

namespace {

constexpr double kBetweenTrials_s = 0.6;
constexpr double kReadsFeedback_s = 1.0;
/// Parts 0 and 1 of a session's seed are its orders.
constexpr std::uint64_t kAnswersOfSession = 2;

} // namespace

SimulatedPerson::SimulatedPerson(StudyRunner& runner, StudyRunner::Clock clock, double speed, QObject* parent)
    : QObject(parent)
    , m_runner(runner)
    , m_clock(std::move(clock))
    , m_speed(speed) {
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedPerson::act);
    connect(&m_runner, &StudyRunner::changed, this, &SimulatedPerson::look);
}

void SimulatedPerson::begin(const study::SimulatedParticipant& mind, std::uint64_t sessionSeed) {
    m_mind = mind;
    m_seed = sessionSeed;
    m_present = true;
    m_answer.reset();
    look();
}

void SimulatedPerson::leave() {
    m_present = false;
    m_timer.stop();
}

/// Decides when to do something next.
void SimulatedPerson::look() {
    const study::Session* session = m_runner.session();
    if (!m_present || session == nullptr || m_runner.waitsForExperimenter() || m_timer.isActive())
        return;
    double wait_s = kBetweenTrials_s;
    if (m_runner.hold() == StudyRunner::Hold::rest) {
        wait_s += m_runner.restLeft_s();
        m_answer.reset();
    } else if (session->stage() == Stage::feedback) {
        wait_s = kReadsFeedback_s;
        m_answer.reset();
    } else if (session->stage() == Stage::ready) {
        m_answer.reset();
    } else if (session->stage() == Stage::stimulus || session->stage() == Stage::answering) {
        const study::PlannedTrial* current = session->current();
        if (m_answer || current == nullptr)
            return;
        const study::PlannedTrial& trial = *current;
        const std::uint64_t part =
            (trial.trial << 16U) + (trial.attempt << 1U) + (trial.phase == study::Phase::test ? 1 : 0);
        m_answer = m_mind.answer(trial.stimulus,
                                 study::derivedSeed(study::derivedSeed(m_seed, kAnswersOfSession), part));
        if (!m_answer->response)
            return;
        wait_s = m_answer->time_s;
    } else {
        return;
    }
    m_timer.start(static_cast<int>(std::lround(std::max(0.0, 1e3 * wait_s / m_speed))));
}

void SimulatedPerson::act() {
    const study::Session* session = m_runner.session();
    if (!m_present || session == nullptr || m_runner.waitsForExperimenter())
        return;
    if (m_runner.hold() == StudyRunner::Hold::rest || session->stage() == Stage::ready ||
        session->stage() == Stage::feedback) {
        m_runner.next(m_clock());
    } else if (m_answer && m_answer->response) {
        const study::KeyPress press{m_answer->response, "simulated", std::to_string(*m_answer->response + 1),
                                    m_clock(), false};
        m_runner.press(press);
        m_runner.release(press.device, press.key);
    }
    look();
}

} // namespace teleta::console
