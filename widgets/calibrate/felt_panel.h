// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/calibrate/felt_task.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include <optional>

namespace teleta::calibrate {

/// Presents bursts one by one and asks the wearer what was felt. An answer needs a presentation first. Keys:
/// Space presents again, Y and Right answer yes, N and Left no, Backspace undoes the last answer.
/// Thread: GUI.
class FeltPanel : public QWidget {
    Q_OBJECT
public:
    explicit FeltPanel(QWidget* parent = nullptr);

    void begin(FeltTask task);
    /// Discards all questions and answers.
    void end() { m_task.reset(); }
    [[nodiscard]] const FeltTask* task() const { return m_task ? &*m_task : nullptr; }
    /// Motors may be fitted meanwhile: their values are kept when the answers are applied.
    void setCalibration(const motors::MotorCalibration& calibration) {
        if (m_task)
            m_task->setCalibration(calibration);
    }
    /// Whether the bracelet can play; if not, nothing can be presented or answered.
    void setReady(bool ready);
    /// Undoes the last answer.
    void undoAnswer();

signals:
    void playRequested(const teleta::playback::Program& program);
    /// All questions are answered: the resulting calibration, and a sentence about it.
    void finished(const teleta::motors::MotorCalibration& calibration, const QString& verdict);
    /// The user has given up.
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void present();
    void answer(bool yes);
    void conclude();
    void refresh();
    void retranslate();

    std::optional<FeltTask> m_task;
    bool m_ready = false;
    bool m_presented = false;
    QLabel* m_title = new QLabel(this);
    QLabel* m_question = base::named<QLabel>("question", this);
    QLabel* m_trouble = new QLabel(this);
    QProgressBar* m_progress = new QProgressBar(this);
    QPushButton* m_play = base::named<QPushButton>("play", this);
    QPushButton* m_yes = base::named<QPushButton>("yes", this);
    QPushButton* m_no = base::named<QPushButton>("no", this);
    QPushButton* m_undo = base::named<QPushButton>("undoAnswer", this);
    QPushButton* m_cancel = base::named<QPushButton>("giveUp", this);
};

} // namespace teleta::calibrate
