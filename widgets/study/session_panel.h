// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"
#include "widgets/base/compose.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QString>
#include <QVBoxLayout>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

class QTableWidget;

namespace teleta::study {

/// How much attention something needs.
enum class Tone { calm, good, attention, alarm };

/// A condition of a run.
struct CheckLine {
    QString name;
    bool passed = false;
    QString finding;
    QString remedy; ///< of a condition that has passed: advice
    friend bool operator==(const CheckLine&, const CheckLine&) = default;
};

/// A finished trial.
struct OutcomeLine {
    QString trial;      ///< "test 12"
    QString level = {}; ///< track and level with its unit; empty: the task has no levels
    QString presented;
    QString answered; ///< a dash: none
    QString outcome;
    Tone tone = Tone::calm;
    std::optional<double> responseTime_s;
    friend bool operator==(const OutcomeLine&, const OutcomeLine&) = default;
};

/// What the session panel shows.
struct SessionScene {
    QString title;    ///< participant and task
    QString subtitle; ///< place in the plan
    Mode mode = Mode::run;
    QString next; ///< the next step, on the large button
    bool nextEnabled = false;
    QString state; ///< what happens now, or why nothing happens
    Tone tone = Tone::calm;
    std::vector<CheckLine> checks; ///< before a run
    QString phase;
    std::size_t done = 0;              ///< of the phase
    std::size_t total = 0;             ///< of the phase; 0: no bar
    std::vector<OutcomeLine> outcomes; ///< newest first
    QString device;
    Tone deviceTone = Tone::calm;
    QString saved; ///< where the results were saved
    bool canPause = false;
    bool canAbort = false;
    bool canNote = false;
    bool canSkip = false;          ///< a questionnaire
    std::size_t questionnaire = 0; ///< number of the one that is asked
    QString skipConsequence;       ///< whether it is asked again
    bool needsNoise = false;
    bool noiseConfirmed = false;
    bool noisePlaying = false;
    QString noiseText;
    friend bool operator==(const SessionScene&, const SessionScene&) = default;
};

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
    /// The button of the next step gets the keyboard as soon as it can be pressed.
    void takeKeyboard();

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
    bool m_keyboardDue = false;
    QLabel* m_title = new QLabel(this);
    QLabel* m_subtitle = new QLabel(this);
    QLabel* m_mark = new QLabel(this);
    QPushButton* m_next = base::named<QPushButton>("nextStep", this);
    QLabel* m_state;
    QWidget* m_checks = new QWidget(this);
    QVBoxLayout* m_checkLines = new QVBoxLayout(m_checks);
    QCheckBox* m_noise = base::named<QCheckBox>("noiseConfirmed", this);
    QPushButton* m_noisePlay = base::named<QPushButton>("noisePlay", this);
    QLabel* m_noiseText = new QLabel(this);
    QWidget* m_noiseRow = new QWidget(this);
    QProgressBar* m_progress = new QProgressBar(this);
    QLabel* m_device = new QLabel(this);
    QLabel* m_saved = new QLabel(this);
    QTableWidget* m_outcomes;
    QLineEdit* m_note = base::named<QLineEdit>("note", this);
    QPushButton* m_window = new QPushButton(this);
    QPushButton* m_skip = base::named<QPushButton>("skip", this);
    QPushButton* m_pause = base::named<QPushButton>("pause", this);
    QPushButton* m_abort = base::named<QPushButton>("abort", this);
};

} // namespace teleta::study
