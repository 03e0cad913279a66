// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/planning/study_truth.h"
#include "backend/study/planning/threshold_plan.h"
#include "backend/study/protocol/protocol.h"
#include "widgets/base/compose.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>

#include <string>

namespace teleta::study {

/// What is assumed of the threshold in a task with levels, and how narrow its interval has to be: a part of
/// the view Plan. Thread: GUI.
class ThresholdForm : public QWidget {
    Q_OBJECT

public:
    explicit ThresholdForm(QWidget* parent = nullptr);

    /// What was filled in stays while the task is the same; otherwise the threshold is in the middle of its
    /// levels.
    void setTask(const StudyTask& task);
    [[nodiscard]] TaskTruth truth() const;
    [[nodiscard]] ThresholdWish wish() const;
    /// Whether truth() counts; wish() counts always.
    void setTruthEnabled(bool enabled);

private:
    void retranslate();

    StudyTask m_task;
    QLabel* m_thresholdLabel = new QLabel(this);
    QDoubleSpinBox* m_threshold = base::named<QDoubleSpinBox>("planThreshold", this);
    QLabel* m_slopeLabel = new QLabel(this);
    QDoubleSpinBox* m_slope = base::named<QDoubleSpinBox>("planSlope", this);
    QLabel* m_lapseLabel = new QLabel(this);
    QDoubleSpinBox* m_lapse_percent = base::named<QDoubleSpinBox>("planLapse", this);
    QLabel* m_guessLabel = new QLabel(this);
    QDoubleSpinBox* m_guess_percent = base::named<QDoubleSpinBox>("planGuess", this);
    QLabel* m_sdLabel = new QLabel(this);
    QDoubleSpinBox* m_sd = base::named<QDoubleSpinBox>("planThresholdSd", this);
    QLabel* m_widthLabel = new QLabel(this);
    QDoubleSpinBox* m_width = base::named<QDoubleSpinBox>("planWidth", this);
    QLabel* m_trialsLabel = new QLabel(this);
    QSpinBox* m_trials = base::named<QSpinBox>("planTrials", this);
    QFormLayout* m_form = new QFormLayout(this);
};

} // namespace teleta::study
