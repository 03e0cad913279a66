// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/calibrate/felt_task.h"

#include <QWidget>

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace teleta::calibrate {

/// Asks a person, presentation by presentation. Keys: Space presents again, Y and the right arrow are yes, N
/// and the left arrow no, Backspace takes the last answer back. An answer counts only after something was
/// presented. Thread: GUI.
class FeltPanel : public QWidget {
    Q_OBJECT
public:
    explicit FeltPanel(QWidget* parent = nullptr);

    void begin(FeltTask task);
    /// Leaves the questions, answered or not.
    void end() { m_task.reset(); }
    [[nodiscard]] const FeltTask* task() const { return m_task ? &*m_task : nullptr; }
    /// A recording may be fitted while somebody answers: its motor stays as it was measured.
    void setCalibration(const motors::MotorCalibration& calibration) {
        if (m_task)
            m_task->setCalibration(calibration);
    }
    /// Whether the bracelet can play; without it nothing can be presented or answered.
    void setReady(bool ready);
    /// Takes the last answer back.
    void undoAnswer();

    [[nodiscard]] QPushButton* playButton() const { return m_play; }
    [[nodiscard]] QPushButton* yesButton() const { return m_yes; }
    [[nodiscard]] QPushButton* noButton() const { return m_no; }
    [[nodiscard]] QPushButton* undoButton() const { return m_undo; }
    [[nodiscard]] QPushButton* cancelButton() const { return m_cancel; }
    [[nodiscard]] QString question() const;

signals:
    void playRequested(const teleta::playback::Program& program);
    /// The answers tell this.
    void finished(const teleta::motors::MotorCalibration& calibration, const QString& verdict);
    /// The person gave up, or the bracelet is to be left alone.
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void present();
    void answer(bool yes);
    void conclude();
    void refresh();
    void retranslate();

    std::optional<FeltTask> m_task;
    bool m_ready = false;
    bool m_presented = false;
    QLabel* m_title;
    QLabel* m_question;
    QLabel* m_trouble;
    QProgressBar* m_progress;
    QPushButton *m_play, *m_yes, *m_no, *m_undo, *m_cancel;
};

} // namespace teleta::calibrate
