// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/study_controller.h"

#include <QMessageBox>
#include <QPointer>

#include <functional>

namespace teleta::console {

/// What must not be lost without a word when the study is left: a session of people that is under way, and
/// what was answered but could not be kept. Thread: GUI.
class StudyLeaving : public QObject {
    Q_OBJECT

public:
    /// controller: must outlive it. parent: of its questions.
    StudyLeaving(StudyController& controller, QWidget& parent);

    /// Nothing has to be asked.
    [[nodiscard]] bool isSettled() const;
    /// Asks, tries again to keep what is not kept if that is wished, and goes on when nothing is left to ask.
    /// At once, where nothing is; never, when somebody thinks better of it.
    void whenSettled(std::function<void()> goOn);

private:
    /// Why the last answers are not kept; empty when they are, or are safe until the server is back.
    [[nodiscard]] QString notKept() const;
    [[nodiscard]] bool isKeeping() const;
    [[nodiscard]] bool isUnderWay() const;
    void settle();
    void askAboutLoss(const QString& reason);
    void askAboutSession();
    void finish();
    [[nodiscard]] QMessageBox* question(const QString& text, const QString& more);

    StudyController& m_controller;
    QWidget& m_parent;
    std::function<void()> m_goOn;
    QPointer<QMessageBox> m_question;
    bool m_waits = false;     ///< for the store
    bool m_isDecided = false; ///< to end the session
};

} // namespace teleta::console
