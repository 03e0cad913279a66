// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_link.h"
#include "widgets/base/controls/badge.h"

#include <QToolButton>
#include <QWidget>

#include <cstddef>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace teleta::servo {

class ForceStrip;
class ServoPicture;

/// Shows a running servo: task, contact, active limits, whether the task is done, features and matrices, and
/// the settings that can be changed while it runs. Knows no source: changes are emitted as signals, and the
/// settings in use come back with the report. Thread: GUI.
class ServoPanel : public QWidget {
    Q_OBJECT
public:
    explicit ServoPanel(QWidget* parent = nullptr);

    /// Empty: there is no servo and the panel is disabled.
    void setReport(const std::optional<ServoReport>& report);

    /// Distinguishes a servo held by STOP from a scene that the user holds.
    void setStopEngaged(bool engaged);

    void setProvenance(base::Provenance provenance);

signals:
    void tuningChanged(const teleta::servo::ServoTuning& tuning);
    void taskRequested(std::size_t index);
    /// The scene goes on, or is held where it is.
    void runRequested(bool running);
    void restartRequested();

private:
    void retranslate();
    void showTexts();
    void showVerdict();
    void showTasks();
    void showTuning(const ServoTuning& tuning, const TuningBounds& bounds);
    /// Says which settings are not those of the scene.
    void showChanges();
    void wish(const ServoTuning& tuning);

    QPushButton* m_run;
    QPushButton* m_hold;
    QPushButton* m_restart;
    QLabel* m_state;
    QLabel* m_limits;
    QLabel* m_verdict;
    ServoPicture* m_picture;
    ForceStrip* m_force20s;
    QLabel* m_cost;
    QFormLayout* m_form;
    QLabel* m_tasksName;
    QComboBox* m_tasks;
    QDoubleSpinBox* m_force;
    QDoubleSpinBox* m_slide;
    QDoubleSpinBox* m_gain;
    QCheckBox* m_moment;
    QLabel* m_changes;
    QPushButton* m_planned; ///< back to the scene's settings
    QToolButton* m_matrices = new QToolButton(this);
    bool m_stopEngaged = true;
    base::Provenance m_shownProvenance = base::Provenance::live;
    std::optional<ServoReport> m_report;
    std::optional<TaskVerdict> m_lastVerdict; ///< of the run before the last restart
    std::optional<ServoTuning> m_wish;        ///< emitted, but not yet in use
};

} // namespace teleta::servo
