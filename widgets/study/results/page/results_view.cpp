// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/page/results_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/results/bracelet_content.h"
#include "widgets/study/results/confusion_view.h"
#include "widgets/study/results/page/comparisons_view.h"
#include "widgets/study/results/result_table.h"
#include "widgets/study/results/results_content.h"
#include "widgets/study/watermark.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace teleta::study {

namespace {

/// Height of a matrix: a part of the page's, within limits.
constexpr double kMatrices = 0.42;
constexpr double kMatrixLow_em = 19.0;
constexpr double kMatrixHigh_em = 34.0;

void fill(ResultTable* table, const TableContent& content) {
    table->setRows(content.header, content.tips, content.rows);
}

QLabel* note(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setFont(base::sized(label->font(), base::kSmallText));
    return label;
}

QLabel* heading(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setFont(base::bold(base::sized(label->font(), base::kTitleText)));
    return label;
}

} // namespace

ResultsView::ResultsView(QWidget* parent)
    : QWidget(parent)
    , m_comparisons(new ComparisonsView(this))
    , m_letters(note(m_content))
    , m_groupsTitle(heading(m_content))
    , m_groups(new ResultTable(QStringLiteral("group"), m_content))
    , m_groupsNote(note(m_content))
    , m_anovaTitle(heading(m_content))
    , m_anova(new ResultTable(QStringLiteral("anova"), m_content))
    , m_anovaNote(note(m_content))
    , m_peopleTitle(heading(m_content))
    , m_people(new ResultTable(QStringLiteral("summary"), m_content)) {
    m_letters->setObjectName(QStringLiteral("letters"));
    m_groups->setObjectName(QStringLiteral("groupTable"));
    m_anova->setObjectName(QStringLiteral("anovaTable"));
    m_people->setObjectName(QStringLiteral("peopleTable"));
    m_counts->addItems({QString(), QString()});
    for (QComboBox* box : {m_task, m_counts})
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_state->setWordWrap(true);
    m_mark->setObjectName(QStringLiteral("modeMark"));
    m_mark->setFont(base::bold(font()));
    auto* bar = new QHBoxLayout;
    base::addWidgets(bar, {m_task, m_who, m_beside, m_counts});
    bar->addWidget(m_state, 1);
    bar->addWidget(m_mark);
    bar->addWidget(m_export);
    auto* charts = new QHBoxLayout;
    charts->addWidget(m_accuracy, 3);
    charts->addWidget(m_patterns, 5);
    charts->addWidget(m_times, 3);
    auto* column = new QVBoxLayout(m_content);
    const int margin = base::grid(this, 2);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(base::grid(this, 1.5));
    column->addLayout(m_matrixGrid);
    column->addWidget(m_letters);
    column->addLayout(charts);
    base::addWidgets(column, {m_groupsTitle, m_groups, m_groupsNote, m_anovaTitle, m_anova, m_anovaNote,
                              m_peopleTitle, m_people});
    column->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(m_content);
    bar->setContentsMargins(margin, 0, margin, 0);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, margin, 0, 0);
    layout->addLayout(bar);
    m_tabs->addTab(area, QString());
    m_tabs->addTab(m_thresholds, QString());
    m_tabs->addTab(m_tracks, QString());
    m_tabs->addTab(m_detection, QString());
    m_tabs->addTab(m_bracelet, QString());
    m_tabs->addTab(m_comparisons, QString());
    m_tabs->setDocumentMode(true);
    layout->addWidget(m_tabs, 1);
    makeNothing();
    layout->addWidget(m_nothing, 1);
    for (FigurePage* page : {m_thresholds, m_tracks, m_detection})
        connect(page, &FigurePage::figureFailed, this, &ResultsView::figureFailed);

    m_export->setMenu(new QMenu(m_export));
    connect(m_task, &QComboBox::currentIndexChanged, this, &ResultsView::refresh);
    for (ParticipantPicker* picker : {m_who, m_beside})
        connect(picker, &ParticipantPicker::chosenChanged, this, &ResultsView::refresh);
    connect(m_counts, &QComboBox::currentIndexChanged, this, [this](int index) {
        for (ConfusionView* view : m_matrices)
            view->setPercent(index == 1);
    });
    for (IntervalChart* chart : {m_accuracy, m_patterns, m_times})
        connect(chart, &IntervalChart::exportFailed, this, &ResultsView::figureFailed);
    for (ResultTable* table : {m_groups, m_anova, m_people})
        connect(&table->exporter(), &base::FigureExport::failed, this, &ResultsView::figureFailed);
    connect(m_comparisons, &ComparisonsView::figureFailed, this, &ResultsView::figureFailed);
    connect(m_bracelet, &BraceletView::figureFailed, this, &ResultsView::figureFailed);
    connect(m_bracelet, &BraceletView::useRequested, this, &ResultsView::useRequested);
    base::keepTranslated(this, &ResultsView::retranslate);
    base::onChange(this, &ResultsView::showMark, {QEvent::PaletteChange});
}

void ResultsView::makeNothing() {
    m_nothing = base::named<QWidget>("noResults", this);
    m_nothingTitle = new QLabel(m_nothing);
    m_nothingTitle->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_nothingNote = new QLabel(m_nothing);
    m_nothingNote->setWordWrap(true);
    auto* column = new QVBoxLayout(m_nothing);
    column->setSpacing(base::grid(this));
    column->addStretch(1);
    for (QLabel* label : {m_nothingTitle, m_nothingNote}) {
        label->setAlignment(Qt::AlignCenter);
        column->addWidget(label);
    }
    column->addStretch(1);
}

void ResultsView::setScene(ResultsScene scene) {
    m_scene = std::move(scene);
    showMark();
    fillChoices();
    refresh();
}

void ResultsView::setState(const QString& state) {
    m_state->setText(state);
}

void ResultsView::setMotors(std::optional<BraceletMotors> motors) {
    m_motors = std::move(motors);
    showLevels();
}

QString ResultsView::task() const {
    return m_task->currentData().toString();
}

ShownPeople ResultsView::shown() const {
    ShownPeople people{m_who->chosen(), {}};
    if (!m_beside->chosen().isEmpty())
        people.beside = m_beside->chosen();
    return people;
}

ConditionNames ResultsView::conditionNames() const {
    return m_scene.conditionNames.value(task());
}

const TaskResults* ResultsView::chosen() const {
    const auto found = std::find_if(m_scene.tasks.begin(), m_scene.tasks.end(), [this](const auto& one) {
        return QString::fromStdString(one.task) == task();
    });
    return found == m_scene.tasks.end() ? nullptr : &*found;
}

const TaskSupplement* ResultsView::supplement() const {
    const TaskResults* results = chosen();
    const auto index = static_cast<std::size_t>(results - m_scene.tasks.data());
    return results != nullptr && index < m_scene.supplements.size() ? &m_scene.supplements[index] : nullptr;
}

/// Keeps the selection when new trials arrive.
void ResultsView::fillChoices() {
    const QString oldTask = task();
    const QSignalBlocker quietTask(m_task);
    const QSignalBlocker quietWho(m_who);
    const QSignalBlocker quietBeside(m_beside);
    m_task->clear();
    std::set<QString> people;
    for (const TaskResults& one : m_scene.tasks) {
        const QString id = QString::fromStdString(one.task);
        m_task->addItem(m_scene.taskNames.value(id, id), id);
        for (const ParticipantSummary& person : one.participants)
            people.insert(QString::fromStdString(person.participant));
    }
    const QStringList all(people.begin(), people.end());
    m_who->setChoices(all, tr("All participants"));
    m_beside->setChoices(all, tr("No comparison"));
    m_task->setCurrentIndex(std::max(0, m_task->findData(oldTask)));
}

void ResultsView::refresh() {
    const TaskResults* results = chosen();
    const bool any = results != nullptr && !results->participants.empty();
    m_tabs->setVisible(any);
    m_nothing->setVisible(!any);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_task, m_who, m_beside, m_counts, m_export})
        widget->setEnabled(any);
    m_comparisons->setContent({any ? results : nullptr, any ? supplement() : nullptr, conditionNames(),
                               &m_scene.tasks, &m_scene.exclusions, m_scene.mode});
    if (!any) {
        showLevels();
        return;
    }
    showMatrices(*results);
    showCharts(*results);
    showTables(*results);
    showLevels();
}

/// The tabs of a task: comparisons where there are some, and those of levels. Shares of right answers depend
/// on the levels that were shown, so they are compared only without levels.
void ResultsView::showLevels() {
    const std::shared_ptr<const LevelResults>& levels = m_scene.levels;
    const bool any = levels && levels->has(task());
    const bool detects = levels && levels->hasDetection(task());
    const bool compares = supplement() != nullptr && !any;
    const bool isOfBracelet = any && BraceletContent::has(*levels, task());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_anovaTitle, m_anova, m_anovaNote})
        widget->setVisible(!any);
    m_tabs->tabBar()->setVisible(any || compares);
    m_tabs->setTabVisible(m_tabs->indexOf(m_comparisons), compares);
    m_tabs->setTabVisible(m_tabs->indexOf(m_thresholds), any);
    m_tabs->setTabVisible(m_tabs->indexOf(m_tracks), any);
    m_tabs->setTabVisible(m_tabs->indexOf(m_detection), detects);
    m_tabs->setTabVisible(m_tabs->indexOf(m_bracelet), isOfBracelet);
    // Of a task with levels thresholds come first, of any other one answers.
    if (any != std::exchange(m_hasLevels, any))
        m_tabs->setCurrentIndex(any ? m_tabs->indexOf(m_thresholds) : 0);
    if (!any)
        return;
    const ConditionNames names = conditionNames();
    const pattern::MotorProfiles* motors = m_motors ? &m_motors->profiles : nullptr;
    m_thresholds->setItems(LevelContent::curves(levels, task(), m_scene.mode, names),
                           LevelContent::thresholdTable(*levels, task(), names, motors));
    m_thresholds->setNote(LevelContent::motorNote(*levels, task(), motors));
    m_bracelet->setContent(levels, task(), names, m_motors, m_scene.mode);
    m_tracks->setItems(LevelContent::tracks(levels, task(), m_scene.mode, names),
                       LevelContent::trackTable(*levels, task(), names));
    m_detection->setItems(LevelContent::detection(levels, task(), m_scene.mode, names),
                          LevelContent::detectionTable(*levels, task(), names));
}

void ResultsView::showMatrices(const TaskResults& results) {
    const std::vector<QStringList> groups = shown().groups();
    const std::size_t columns = results.conditions.size();
    const ConditionNames names = conditionNames();
    while (m_matrices.size() > groups.size() * columns) {
        delete m_matrices.back();
        m_matrices.pop_back();
    }
    while (m_matrices.size() < groups.size() * columns) {
        auto* view = new ConfusionView(m_content);
        view->setPercent(m_counts->currentIndex() == 1);
        connect(view, &ConfusionView::percentChanged, this,
                [this](bool percent) { m_counts->setCurrentIndex(percent ? 1 : 0); });
        connect(view, &ConfusionView::exportFailed, this, &ResultsView::figureFailed);
        m_matrices.push_back(view);
    }
    for (std::size_t i = 0; i < m_matrices.size(); ++i) {
        const QStringList& group = groups[i / columns];
        const std::string& condition = results.conditions[i % columns];
        const QString id = QString::fromStdString(condition);
        ConfusionContent content;
        content.matrix = ResultsContent::matrix(results, condition, group);
        for (const std::string& letter : results.patterns)
            content.letters << QString::fromStdString(letter);
        content.title =
            tr("%1, %2", "condition, participant").arg(names.value(id, id), ResultsContent::nameOf(group));
        content.mode = m_scene.mode;
        m_matrices[i]->setContent(std::move(content));
        m_matrixGrid->addWidget(m_matrices[i], static_cast<int>(i / columns), static_cast<int>(i % columns));
    }
    const QMap<QString, QString> patterns = m_scene.patternNames.value(task());
    QStringList legend;
    for (const std::string& pattern : results.patterns) {
        const QString letter = QString::fromStdString(pattern);
        if (const QString name = patterns.value(letter); !name.isEmpty() && name != letter)
            legend << tr("%1: %2", "letter of a pattern, its name").arg(letter, name);
    }
    m_letters->setText(legend.join(QStringLiteral("   ")));
    m_letters->setVisible(!legend.isEmpty());
    giveMatricesRoom();
}

void ResultsView::giveMatricesRoom() {
    const int room = static_cast<int>(kMatrices * height());
    for (ConfusionView* view : m_matrices)
        view->setMinimumHeight(
            std::clamp(room, base::em(this, kMatrixLow_em), base::em(this, kMatrixHigh_em)));
}

void ResultsView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    giveMatricesRoom();
}

void ResultsView::showCharts(const TaskResults& results) {
    const auto set = [this](IntervalChart* chart, IntervalChartContent content) {
        content.mode = m_scene.mode;
        chart->setContent(std::move(content));
        chart->setMinimumHeight(base::em(this, 17));
    };
    const TaskSupplement* extra = supplement();
    set(m_accuracy, ResultsContent::accuracy(results, shown(), conditionNames()));
    set(m_patterns, ResultsContent::patterns(results, shown(), conditionNames(),
                                             extra != nullptr ? &extra->comparisons : nullptr));
    set(m_times, ResultsContent::times(results, shown(), conditionNames()));
}

void ResultsView::showTables(const TaskResults& results) {
    fill(m_groups, ResultsContent::groups(results, conditionNames()));
    fill(m_anova, ResultsContent::anova(results));
    fill(m_people, ResultsContent::people(results, shown(), conditionNames()));
    m_groupsNote->setText(ResultsContent::transferNote(results));
    m_anovaNote->setText(ResultsContent::anovaNote(results));
}

void ResultsView::showMark() {
    m_mark->setText(modeMark(m_scene.mode));
    base::setTextColour(m_mark, modeColour(m_scene.mode, palette()));
}

void ResultsView::retranslate() {
    showMark();
    m_nothingTitle->setText(tr("No results yet"));
    m_nothingNote->setText(
        tr("Each task's confusion matrices, accuracy and response times appear here while test "
           "trials are completed."));
    m_task->setAccessibleName(tr("Task"));
    m_who->setAccessibleName(tr("Participants shown"));
    m_who->setToolTip(tr("Tick one participant, or a group"));
    m_beside->setAccessibleName(tr("Participants for comparison"));
    m_beside->setToolTip(tr("Tick the participants to compare with: a second group, side by side"));
    m_counts->setAccessibleName(tr("What the matrices show"));
    m_counts->setItemText(0, tr("Counts"));
    m_counts->setItemText(1, tr("Percent of the row"));
    m_tabs->setTabText(m_tabs->indexOf(m_comparisons), tr("Comparisons"));
    m_groupsTitle->setText(tr("All participants together"));
    m_anovaTitle->setText(tr("Analysis of variance"));
    m_peopleTitle->setText(tr("Each participant"));
    m_tabs->setTabText(0, tr("Answers"));
    m_tabs->setTabText(m_tabs->indexOf(m_thresholds), tr("Thresholds"));
    m_tabs->setTabText(m_tabs->indexOf(m_tracks), tr("Tracks"));
    m_tabs->setTabText(m_tabs->indexOf(m_detection), tr("d' and c"));
    m_tabs->setTabText(m_tabs->indexOf(m_bracelet), tr("Bracelet"));
    m_thresholds->setChoiceName(tr("Whose threshold is shown"));
    m_thresholds->setTableName(tr("Thresholds"));
    m_tracks->setChoiceName(tr("Which track is shown"));
    m_tracks->setTableName(tr("Tracks"));
    m_detection->setChoiceName(tr("Which condition is shown"));
    m_detection->setTableName(tr("d' and c"));
    m_groups->setAccessibleName(m_groupsTitle->text());
    m_anova->setAccessibleName(m_anovaTitle->text());
    m_people->setAccessibleName(m_peopleTitle->text());
    m_export->setText(tr("&Export"));
    m_export->setToolTip(tr("Writes the trials, or these results, into the folder of the study"));
    m_export->menu()->clear();
    const auto add = [this](const QString& text, const QString& format) {
        m_export->menu()->addAction(text, this, [this, format] { emit exportRequested(format); });
    };
    add(tr("Trials as &Psych-DS (CSV)"), QStringLiteral("psychds"));
    add(tr("Trials as &BIDS (TSV)"), QStringLiteral("bids"));
    add(tr("Trials for a &spreadsheet"), QStringLiteral("excel"));
    add(tr("&Results: tables, figures, R script"), QStringLiteral("analysis"));
    fillChoices();
    refresh();
}

} // namespace teleta::study
