// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/questionnaire_sequence.h"

#include <QDateTime>

#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

constexpr double kSimulatedTakes_ms = 2000.0;

} // namespace

QuestionnaireSequence::QuestionnaireSequence(StudyStoreThread& store, QObject* parent)
    : QObject(parent)
    , m_store(store) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this] { submit(m_filledIn); });
}

void QuestionnaireSequence::begin(Subject subject, std::vector<study::DueQuestionnaire> due,
                                  std::function<void()> done) {
    leave();
    m_subject = std::move(subject);
    m_due = std::move(due);
    m_done = std::move(done);
    showNext();
}

void QuestionnaireSequence::leave() {
    ++m_run;
    m_timer.stop();
    m_due.clear();
    m_done = {};
    m_filledIn.clear();
    m_given.clear();
    m_keeping = m_skipping = false;
    m_problem.clear();
}

bool QuestionnaireSequence::isSimulated() const {
    return m_subject.head.mode == study::Mode::simulated;
}

const study::Questionnaire* QuestionnaireSequence::current() const {
    return m_due.empty() ? nullptr : &m_current;
}

void QuestionnaireSequence::showNext() {
    if (m_due.empty()) {
        if (const std::function<void()> done = std::exchange(m_done, {}))
            done();
        emit changed();
        return;
    }
    ++m_shown;
    m_current =
        study::shownQuestionnaire(m_subject.head, m_subject.participant, m_subject.plan, m_due.front().index);
    if (isSimulated()) {
        m_filledIn = study::simulatedAnswers(m_subject.head, m_subject.participant, m_subject.plan,
                                             m_due.front().index);
        m_timer.start(static_cast<int>(std::lround(kSimulatedTakes_ms / m_speed)));
    }
    emit changed();
}

void QuestionnaireSequence::submit(std::vector<study::ItemAnswer> answers) {
    if (current() == nullptr || m_keeping)
        return;
    m_given = std::move(answers);
    m_skipping = false;
    keep();
}

void QuestionnaireSequence::skip(std::size_t shown) {
    if (current() == nullptr || m_keeping || shown != m_shown)
        return;
    m_timer.stop();
    m_skipping = true;
    keep();
}

void QuestionnaireSequence::retry() {
    if (current() != nullptr && !m_keeping && !m_problem.isEmpty())
        keep();
}

void QuestionnaireSequence::keep() {
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (m_skipping) {
        // Part of the data: not translated.
        askToKeep([session = m_subject.session, text = "questionnaire skipped: " + current()->id,
                   now](StudyStoreThread::Store& store) { return store->keepNote(session, text, now); });
        return;
    }
    const study::Questionnaire& questionnaire =
        m_subject.head.protocol.questionnaires.at(m_due.front().index);
    askToKeep([participant = m_subject.participant, session = m_due.front().session, questionnaire,
               answers = study::inOrderOfItems(questionnaire, m_given), now](StudyStoreThread::Store& store) {
        return store->keepAnswers(participant, session, questionnaire, answers, now);
    });
}

template <typename Work>
void QuestionnaireSequence::askToKeep(Work work) {
    m_keeping = true;
    m_problem.clear();
    m_store.ask(std::move(work), [this, run = m_run](const core::Expected<void>& kept) {
        if (run != m_run)
            return;
        m_keeping = false;
        if (kept) {
            next();
            return;
        }
        m_problem = QString::fromStdString(core::describe(kept.error()));
        emit changed();
    });
    emit changed();
}

void QuestionnaireSequence::next() {
    ++m_run;
    m_skipping = false;
    m_problem.clear();
    m_filledIn.clear();
    m_given.clear();
    m_due.erase(m_due.begin());
    showNext();
}

} // namespace teleta::console
