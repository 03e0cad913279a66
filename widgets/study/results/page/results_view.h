// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/exclusion_results.h"
#include "backend/study/model/task_supplement.h"
#include "backend/study/protocol/trial.h"
#include "widgets/base/compose.h"
#include "widgets/study/results/interval_chart.h"
#include "widgets/study/results/level_content.h"
#include "widgets/study/results/page/bracelet_view.h"
#include "widgets/study/results/participant_picker.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QMap>
#include <QPushButton>
#include <QString>
#include <QTabWidget>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace teleta::study {

class ConfusionView;
class ComparisonsView;
class ResultTable;
struct ShownPeople;
using ConditionNames = QMap<QString, QString>;

/// Results of a study, and names of its parts.
struct ResultsScene {
    std::vector<TaskResults> tasks;
    std::vector<TaskSupplement> supplements = {}; ///< of the tasks, in their order
    ExclusionReport exclusions = {};
    QMap<QString, QString> taskNames;             ///< by id
    QMap<QString, ConditionNames> conditionNames; ///< by id of the task
    /// Names of the patterns by letter, by id of the task.
    QMap<QString, QMap<QString, QString>> patternNames = {};
    Mode mode = Mode::run;
    std::shared_ptr<const LevelResults> levels = {}; ///< of tasks with levels; null: none
};

/// The results of a study: confusion matrices, accuracy with intervals, conditions compared for each pattern,
/// response times, information transfer with its bias, ANOVA; in a tab of their own pairs, ranks, model and
/// exclusions. Tasks with levels have further tabs: thresholds, tracks, d' and c, and what they say of the
/// bracelet. All of it can be copied and saved. Thread: GUI.
class ResultsView : public QWidget {
    Q_OBJECT

public:
    explicit ResultsView(QWidget* parent = nullptr);

    void setScene(ResultsScene scene);
    /// State of the results: being computed, none yet.
    void setState(const QString& state);
    /// The connected bracelet; empty: none.
    void setMotors(std::optional<BraceletMotors> motors);
    [[nodiscard]] QString task() const;
    /// Conditions from left to right; the second group below.
    [[nodiscard]] const std::vector<ConfusionView*>& matrices() const { return m_matrices; }

signals:
    /// psychds, bids, excel, or analysis for the files of this page.
    void exportRequested(const QString& format);
    void figureFailed(const QString& message);
    /// See BraceletView.
    void useRequested(const teleta::pattern::MotorProfiles& balanced, const QString& from);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeNothing();
    void retranslate();
    void showMark();
    void fillChoices();
    void refresh();
    void showMatrices(const TaskResults& task);
    void giveMatricesRoom();
    void showCharts(const TaskResults& task);
    void showTables(const TaskResults& task);
    void showLevels();
    [[nodiscard]] ConditionNames conditionNames() const;
    [[nodiscard]] const TaskResults* chosen() const;
    [[nodiscard]] const TaskSupplement* supplement() const;
    [[nodiscard]] ShownPeople shown() const;

    ResultsScene m_scene;
    std::optional<BraceletMotors> m_motors;
    bool m_hasLevels = false; ///< the chosen task
    QComboBox* m_task = base::named<QComboBox>("resultTask", this);
    ParticipantPicker* m_who = base::named<ParticipantPicker>("resultParticipant", this);
    ParticipantPicker* m_beside = base::named<ParticipantPicker>("resultBeside", this);
    QComboBox* m_counts = base::named<QComboBox>("resultCounts", this);
    QPushButton* m_export = base::named<QPushButton>("resultExport", this);
    QLabel* m_state = new QLabel(this);
    QLabel* m_mark = new QLabel(this); ///< of a pilot or a simulated study
    QWidget* m_content = new QWidget(this);
    QTabWidget* m_tabs = base::named<QTabWidget>("resultTabs", this);
    QWidget* m_nothing; ///< in its place while there are no results
    QLabel* m_nothingTitle;
    QLabel* m_nothingNote;
    FigurePage* m_thresholds = new FigurePage(QStringLiteral("thresholds"), this);
    FigurePage* m_tracks = new FigurePage(QStringLiteral("tracks"), this);
    FigurePage* m_detection = new FigurePage(QStringLiteral("sdt"), this);
    BraceletView* m_bracelet = new BraceletView(this);
    ComparisonsView* m_comparisons;
    QGridLayout* m_matrixGrid = new QGridLayout;
    std::vector<ConfusionView*> m_matrices;
    IntervalChart* m_accuracy = base::named<IntervalChart>("accuracyChart", m_content);
    IntervalChart* m_patterns = base::named<IntervalChart>("patternChart", m_content);
    IntervalChart* m_times = base::named<IntervalChart>("timeChart", m_content);
    QLabel* m_letters; ///< what the letters of the matrices stand for
    QLabel* m_groupsTitle;
    ResultTable* m_groups;
    QLabel* m_groupsNote;
    QLabel* m_anovaTitle;
    ResultTable* m_anova;
    QLabel* m_anovaNote;
    QLabel* m_peopleTitle;
    ResultTable* m_people;
};

} // namespace teleta::study
