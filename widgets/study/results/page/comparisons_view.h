// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/trials/exclusion_results.h"
#include "backend/study/model/task_supplement.h"
#include "backend/study/protocol/trial.h"
#include "widgets/base/compose.h"

#include <QLabel>
#include <QMap>
#include <QScrollArea>
#include <QString>

#include <vector>

namespace teleta::study {

class CurveView;
class ResultTable;
using ConditionNames = QMap<QString, QString>;

/// What the view shows; nothing is kept after setContent().
struct ComparisonsScene {
    const TaskResults* task = nullptr;
    const TaskSupplement* supplement = nullptr; ///< null: not computed
    ConditionNames names = {};
    const std::vector<TaskResults>* tasks = nullptr; ///< all of the study
    const ExclusionReport* exclusions = nullptr;
    Mode mode = Mode::run;
};

/// Comparisons of a task: pairs of levels with Holm's p and effect sizes, ranks, the model of single answers,
/// response times, and what the rules of exclusions changed. Thread: GUI.
class ComparisonsView : public QScrollArea {
    Q_OBJECT

public:
    explicit ComparisonsView(QWidget* parent = nullptr);

    void setContent(const ComparisonsScene& scene);

signals:
    void figureFailed(const QString& message);

private:
    /// A table with its title and a remark below.
    struct Section {
        QLabel* title = nullptr;
        ResultTable* table = nullptr;
        QLabel* note = nullptr;
    };
    [[nodiscard]] Section addSection(const char* name);
    void retranslate();
    static void showSection(const Section& section, bool visible);

    QWidget* m_content = new QWidget;
    Section m_pairs;
    Section m_effects;
    Section m_ranks;
    Section m_model;
    CurveView* m_curves;
    Section m_times;
    Section m_rules;
    Section m_without;
};

} // namespace teleta::study
