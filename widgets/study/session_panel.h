// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/study/session_scene.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace teleta::study {

/// The experimenter's view of a session: the next step as one large button, checks before a run, progress,
/// the last outcomes, the device, notes. Thread: GUI.
class SessionPanel : public QWidget {
    Q_OBJECT

public:
    explicit SessionPanel(QWidget* parent = nullptr);

    void setScene(const SessionScene& scene);
    /// Puts a note that could not be saved back into its field, before newer text.
    void restoreNote(const QString& text);
    [[nodiscard]] const SessionScene& scene() const { return m_scene; }

signals:
    void nextRequested();
    void pauseRequested();
    /// After the experimenter has confirmed it.
    void abortRequested();
    /// The same for skipping a questionnaire: that of SessionScene::questionnaire.
    void skipRequested(std::size_t questionnaire);
    void noteWritten(const QString& text);
    void noiseConfirmed(bool confirmed);
    void noisePlayRequested(bool play);
    void participantWindowRequested();

private:
    void retranslate();
    void refresh();
    void showChecks();
    void showOutcomes();
    void showNewOutcomes(const std::vector<OutcomeLine>& before);
    void showOutcome(int row);
    void askForAbort();
    void askForSkip();

    SessionScene m_scene;
    QLabel* m_title;
    QLabel* m_subtitle;
    QLabel* m_mark;
    QPushButton* m_next;
    QLabel* m_state;
    QWidget* m_checks;
    QVBoxLayout* m_checkLines;
    QCheckBox* m_noise;
    QPushButton* m_noisePlay;
    QLabel* m_noiseText;
    QWidget* m_noiseRow;
    QProgressBar* m_progress;
    QLabel* m_device;
    QLabel* m_saved;
    QTableWidget* m_outcomes;
    QLineEdit* m_note;
    QPushButton* m_window;
    QPushButton* m_skip;
    QPushButton* m_pause;
    QPushButton* m_abort;
};

} // namespace teleta::study
