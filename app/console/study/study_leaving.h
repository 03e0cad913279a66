// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/study_controller.h"

#include <QMessageBox>
#include <QPointer>

#include <functional>

namespace teleta::console {

/// Asks before the study is left if something would be lost: a running session with people, or answers that
/// could not be saved. Thread: GUI.
class StudyLeaving : public QObject {
    Q_OBJECT

public:
    /// controller: must outlive it. parent: of its questions.
    StudyLeaving(StudyController& controller, QWidget& parent);

    /// There is nothing to ask.
    [[nodiscard]] bool isSettled() const;
    /// Asks, retries to save if wanted, and calls goOn when nothing is left to ask: at once if there is
    /// nothing, never if the user cancels.
    void whenSettled(std::function<void()> goOn);

private:
    /// Why the last answers are not saved; empty: they are, or are safe until the server is back.
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
    bool m_waits = false;     ///< waits for the store
    bool m_isDecided = false; ///< the user has decided to end the session
};

} // namespace teleta::console
