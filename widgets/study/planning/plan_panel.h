// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/study/planning/plan_content.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include <optional>
#include <vector>

namespace teleta::study {

class CurveView;
class ThresholdForm;

/// How many participants does a test need? A form of what is assumed on the left, the power over the number
/// of participants on the right. It computes nothing. Thread: GUI.
class PlanPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlanPanel(QWidget* parent = nullptr);

    /// What was filled in stays while the tasks and conditions are the same.
    void setProtocol(const Protocol& protocol);
    /// Assumes what a file or a pilot says. source: named on the page; empty: what the form says again.
    void setTruth(const StudyTruth& truth, const QString& source);
    /// What the form says now. Empty: there is nothing to plan.
    [[nodiscard]] std::optional<PlanRequest> request() const;

    /// While a plan is computed the form is locked. done: 0 .. 1.
    void setRunning(double done);
    void setPlan(const PowerPlan& plan, const PlanRequest& request);
    /// Why there is no plan.
    void setProblem(const QString& text);

signals:
    void planRequested();
    void cancelRequested();
    void truthFileRequested();
    void pilotRequested(); ///< assume what this study's results show
    void figureFailed(const QString& message);

private:
    void retranslate();
    void showConditions();
    void alignFields();
    void showSource();
    void showNoPlan();
    [[nodiscard]] const StudyTask* task() const;
    [[nodiscard]] bool isOfThreshold() const;

    Protocol m_protocol;
    std::optional<StudyTruth> m_truth; ///< of a file or a pilot
    QString m_source;
    bool m_running = false;
    bool m_wasOfThreshold = false; ///< the test before
    bool m_isPlanned = false;      ///< the curve shows a plan of this protocol

    QFormLayout* m_form = new QFormLayout;
    QLabel* m_testLabel = new QLabel(this);
    QComboBox* m_test = base::named<QComboBox>("planTest", this);
    QFormLayout* m_shares = new QFormLayout;
    std::vector<QDoubleSpinBox*> m_share_percent; ///< one per condition
    ThresholdForm* m_threshold;
    QLabel* m_participantLabel = new QLabel(this);
    QDoubleSpinBox* m_participantSd = base::named<QDoubleSpinBox>("planParticipantSd", this);
    QLabel* m_conditionLabel = new QLabel(this);
    QDoubleSpinBox* m_conditionSd = base::named<QDoubleSpinBox>("planConditionSd", this);
    QLabel* m_sourceLabel = new QLabel(this);
    QPushButton* m_file = base::named<QPushButton>("planFile", this);
    QPushButton* m_pilot = base::named<QPushButton>("planPilot", this);
    QPushButton* m_own = base::named<QPushButton>("planOwn", this);
    QLabel* m_rangeLabel = new QLabel(this);
    QSpinBox* m_from = base::named<QSpinBox>("planFrom", this);
    QSpinBox* m_to = base::named<QSpinBox>("planTo", this);
    QSpinBox* m_step = base::named<QSpinBox>("planStep", this);
    QLabel* m_targetLabel = new QLabel(this);
    QDoubleSpinBox* m_target_percent = base::named<QDoubleSpinBox>("planTarget", this);
    QLabel* m_studiesLabel = new QLabel(this);
    QComboBox* m_studies = base::named<QComboBox>("planStudies", this);
    QPushButton* m_start = base::named<QPushButton>("planStart", this);
    QPushButton* m_cancel = base::named<QPushButton>("planCancel", this);
    QProgressBar* m_progress = base::named<QProgressBar>("planProgress", this);
    QLabel* m_answer = base::named<QLabel>("planAnswer", this);
    CurveView* m_curve;
};

} // namespace teleta::study
