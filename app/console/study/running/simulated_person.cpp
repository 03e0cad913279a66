// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/simulated_person.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::Stage;

namespace {

constexpr double kBetweenTrials_s = 0.6;
constexpr double kReadsFeedback_s = 1.0;

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

void SimulatedPerson::begin(Answers answers, std::uint64_t sessionSeed) {
    m_answers = std::move(answers);
    m_seed = sessionSeed;
    m_present = true;
    m_answer.reset();
    look();
}

void SimulatedPerson::leave() {
    m_present = false;
    m_timer.stop();
}

/// Decides what to do next, and when.
void SimulatedPerson::look() {
    const study::SessionFlow* flow = m_runner.flow();
    if (!m_present || flow == nullptr || flow->waitsForExperimenter() || m_timer.isActive())
        return;
    const study::Session& session = flow->session();
    double wait_s = kBetweenTrials_s;
    if (flow->hold() == study::Hold::rest) {
        wait_s += m_runner.restLeft_s();
        m_answer.reset();
    } else if (session.stage() == Stage::feedback) {
        wait_s = kReadsFeedback_s;
        m_answer.reset();
    } else if (session.stage() == Stage::ready) {
        m_answer.reset();
    } else if (session.stage() == Stage::stimulus || session.stage() == Stage::answering) {
        const study::PlannedTrial* current = session.current();
        if (m_answer || current == nullptr)
            return;
        m_answer = m_answers(*current, study::answerSeed(m_seed, *current));
        if (!m_answer->response)
            return;
        wait_s = m_answer->time_s;
    } else {
        return;
    }
    m_timer.start(static_cast<int>(std::lround(std::max(0.0, 1e3 * wait_s / m_speed))));
}

void SimulatedPerson::act() {
    const study::SessionFlow* flow = m_runner.flow();
    if (!m_present || flow == nullptr || flow->waitsForExperimenter())
        return;
    const Stage stage = flow->session().stage();
    if (flow->hold() == study::Hold::rest || stage == Stage::ready || stage == Stage::feedback) {
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
