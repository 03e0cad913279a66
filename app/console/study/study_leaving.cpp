// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_leaving.h"

#include <QPushButton>

#include <utility>

namespace teleta::console {

StudyLeaving::StudyLeaving(StudyController& controller, QWidget& parent)
    : QObject(&parent)
    , m_controller(controller)
    , m_parent(parent) {
    connect(&m_controller, &StudyController::changed, this, [this] {
        if (m_waits)
            settle();
    });
}

QString StudyLeaving::notKept() const {
    // A result that waits for its server is safe on this machine.
    const StudyRunner& runner = m_controller.runner();
    if (runner.hold() == study::Hold::notKept && !runner.flow()->waitsForServer())
        return runner.reason();
    return m_controller.questionnaires().problem();
}

bool StudyLeaving::isKeeping() const {
    return m_controller.runner().isKeeping() || m_controller.questionnaires().isKeeping();
}

bool StudyLeaving::isUnderWay() const {
    if (!m_controller.isActive())
        return false;
    const study::Session* session = m_controller.runner().session();
    return m_controller.questionnaires().current() != nullptr ||
           (session != nullptr && session->stage() != study::Stage::finished &&
            session->stage() != study::Stage::aborted);
}

/// Simulated participants can repeat everything.
bool StudyLeaving::isSettled() const {
    if (!m_controller.overview() || m_controller.overview()->head.mode == study::Mode::simulated)
        return true;
    return notKept().isEmpty() && !isKeeping() && !isUnderWay();
}

void StudyLeaving::whenSettled(std::function<void()> goOn) {
    m_goOn = std::move(goOn);
    m_isDecided = false;
    if (m_question)
        m_question->raise();
    else
        settle();
}

void StudyLeaving::settle() {
    m_waits = !isSettled() && isKeeping();
    if (m_waits)
        return;
    if (isSettled()) {
        finish();
        return;
    }
    if (const QString reason = notKept(); !reason.isEmpty())
        askAboutLoss(reason);
    else if (m_isDecided)
        finish();
    else
        askAboutSession();
}

void StudyLeaving::finish() {
    if (const auto goOn = std::exchange(m_goOn, nullptr))
        goOn();
}

QMessageBox* StudyLeaving::question(const QString& text, const QString& more) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Study"), text, QMessageBox::Cancel, &m_parent);
    box->setInformativeText(more);
    box->setAttribute(Qt::WA_DeleteOnClose);
    m_question = box;
    return box;
}

void StudyLeaving::askAboutLoss(const QString& reason) {
    QMessageBox* box =
        question(tr("The last answer is not saved: %1").arg(reason),
                 tr("It exists only in the memory of this program and is lost when the session ends."));
    box->setObjectName(QStringLiteral("notKept"));
    QPushButton* again = box->addButton(tr("&Try again"), QMessageBox::AcceptRole);
    box->addButton(tr("&Discard it"), QMessageBox::DestructiveRole);
    box->setDefaultButton(again);
    connect(box, &QMessageBox::finished, this, [this, box] {
        const auto role = box->buttonRole(box->clickedButton());
        m_question = nullptr;
        if (role == QMessageBox::DestructiveRole) {
            finish();
        } else if (role == QMessageBox::AcceptRole) {
            m_waits = m_isDecided = true;
            if (m_controller.questionnaires().problem().isEmpty())
                m_controller.runner().retry();
            else
                m_controller.questionnaires().retry();
        }
    });
    box->open();
}

void StudyLeaving::askAboutSession() {
    const ParticipantOverview* participant = m_controller.chosenParticipant();
    QMessageBox* box = question(
        tr("The session of %1 is still running.", "a participant")
            .arg(participant == nullptr ? QString() : QString::fromStdString(participant->participant.id)),
        tr("All answers are saved, and the session can be resumed later."));
    box->setObjectName(QStringLiteral("endSession"));
    QPushButton* end = box->addButton(tr("&End the session"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, box, end] {
        const bool ends = box->clickedButton() == end;
        m_question = nullptr;
        m_isDecided = ends;
        // A trial may have been answered while the question was open.
        if (ends)
            settle();
    });
    box->open();
}

} // namespace teleta::console
