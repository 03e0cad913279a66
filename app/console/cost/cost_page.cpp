// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/cost_page.h"

#include "app/common/scene_file.h"
#include "app/console/cost/apart_items.h"
#include "app/console/cost/cost_words.h"
#include "app/console/cost/sweep_panel.h"
#include "backend/cost/frontier.h"
#include "backend/vision/finders/contact_ladder.h"
#include "widgets/base/compose.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/camera/stage_bar.h"
#include "widgets/chrome/empty_state.h"
#include "widgets/cost/cost_chart.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace teleta::console {

namespace {

constexpr char kCameraLadder[] = "contact-flow";
constexpr double kUsualBudget_ms = 8.0;

/// Of an item that is a heading.
constexpr int kTopicRole = Qt::UserRole + 1;

enum Column {
    rungColumn,
    parameterColumn,
    errorColumn,
    p95Column,
    worstColumn,
    timeColumn,
    p99Column,
    columns
};

QLabel* heading(QWidget* parent, double size = base::kTitleText) {
    auto* label = new QLabel(parent);
    label->setFont(base::bold(base::sized(label->font(), size)));
    return label;
}

/// Stacks widgets in a column of the page.
QVBoxLayout* columnOf(QWidget* column, std::initializer_list<QWidget*> widgets) {
    auto* layout = new QVBoxLayout(column);
    const int margin = base::grid(column, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(column));
    base::addWidgets(layout, widgets);
    return layout;
}

QLabel* wrapped(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    return label;
}

} // namespace

CostPage::CostPage(const CostMeasuring::MakeLadders& makeLadders, const QString& file,
                   const cost::MeasureSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_measuring(new CostMeasuring(makeLadders, file, settings, this))
    , m_messages(new chrome::MessageBar(this))
    , m_tabs(base::named<QTabWidget>("costTabs", this))
    , m_sweeps(new SweepPanel(
          [makeLadders] {
              return sweep::SubjectSources{[](const std::string& name) { return app::sceneText(name); },
                                           makeLadders()};
          },
          this)) {
    auto* split = new QSplitter(this);
    split->setChildrenCollapsible(false);
    split->addWidget(makeLadderColumn());
    // The table lies below chart and camera: its seven columns need the width of both.
    auto* beside = new QSplitter(split);
    beside->setChildrenCollapsible(false);
    beside->addWidget(makeMiddle());
    beside->addWidget(makeCameraColumn());
    beside->setStretchFactor(0, 1);
    auto* right = new QSplitter(Qt::Vertical, split);
    right->setChildrenCollapsible(false);
    right->addWidget(beside);
    right->addWidget(makeTable());
    right->setStretchFactor(0, 3);
    right->setStretchFactor(1, 2);
    split->addWidget(right);
    split->setStretchFactor(1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(split, QString());
    m_tabs->addTab(m_sweeps, QString());
    layout->addWidget(m_tabs, 1);

    connect(m_measuring, &CostMeasuring::changed, this, [this] {
        showLadders();
        showCosts();
    });
    connect(m_measuring, &CostMeasuring::runningChanged, this, &CostPage::showRunning);
    connect(m_measuring, &CostMeasuring::failed, this, [this](const QString& what, const QString& details) {
        m_messages->post({chrome::Message::Severity::error, what, details, QString()});
    });
    connect(m_sweeps, &SweepPanel::failed, this, [this](const QString& what, const QString& details) {
        m_messages->post({chrome::Message::Severity::error, what, details, QString()});
    });
    connect(m_list, &QListWidget::currentRowChanged, this, &CostPage::showCosts);
    connect(m_measure, &QPushButton::clicked, this, [this] { m_measuring->start(ladderShown()); });
    connect(m_measureAll, &QPushButton::clicked, this, [this] { m_measuring->start({}); });
    connect(m_measureEmpty, &QPushButton::clicked, m_measure, &QPushButton::click);
    connect(m_cancel, &QPushButton::clicked, m_measuring, &CostMeasuring::cancel);
    connect(m_chart, &cost::CostChart::rungClicked, this, [this](const QString& name) {
        for (int row = 0; row < m_table->rowCount(); ++row)
            if (m_table->item(row, rungColumn)->data(Qt::UserRole).toString() == name)
                m_table->setCurrentCell(row, rungColumn);
    });
    connect(m_chart, &cost::CostChart::exportFailed, this, [this](const QString& message) {
        m_messages->post({chrome::Message::Severity::error, message, QString(), QString()});
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        const QTableWidgetItem* item = m_table->item(row, rungColumn);
        m_chart->setChosen(item == nullptr ? QString() : item->data(Qt::UserRole).toString());
        showWords();
    });
    connect(m_rungs, &QComboBox::activated, this, [this] { chooseRung(m_rungs->currentData().toString()); });
    connect(m_budget_ms, &QDoubleSpinBox::valueChanged, this, &CostPage::showBudget);
    connect(m_useBest, &QPushButton::clicked, this, [this] { chooseRung(m_best); });
    connect(m_openCamera, &QPushButton::clicked, this, &CostPage::demoCameraRequested);

    retranslate();
    base::onChange(this,
                   [this] {
                       m_measuring->retranslate();
                       m_sweeps->retranslate();
                       retranslate();
                   },
                   {QEvent::LanguageChange});
    m_list->setCurrentRow(m_list->item(0)->flags().testFlag(Qt::ItemIsEnabled) ? 0 : 1);
    showRunning();
    tick(nullptr);
}

QWidget* CostPage::makeLadderColumn() {
    auto* column = new QWidget(this);
    m_ladderHeading = heading(column);
    m_list = base::named<QListWidget>("ladders", column);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setItemDelegate(new ApartItems(m_list));
    m_measure = base::named<QPushButton>("measure", column);
    m_measureAll = base::named<QPushButton>("measureAll", column);
    m_cancel = base::named<QPushButton>("cancel", column);
    m_progress = new QProgressBar(column);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progressText = wrapped(column);
    // Those of a topic below its heading, in the order in which each topic is first met.
    std::vector<const cost::Ladder*> left;
    for (const cost::Ladder& ladder : m_measuring->ladders())
        left.push_back(&ladder);
    while (!left.empty()) {
        const std::optional<cost::Topic> topic = left.front()->topic;
        if (topic) {
            ApartItems::addHeading(*m_list)->setData(kTopicRole, static_cast<int>(*topic));
        }
        std::erase_if(left, [&](const cost::Ladder* ladder) {
            if (ladder->topic != topic)
                return false;
            auto* item = new QListWidgetItem(m_list);
            item->setData(Qt::UserRole, QString::fromStdString(ladder->name));
            return true;
        });
    }
    // Cancel keeps its place, so that a click that is meant for it never starts a measurement; the list gives
    // the room that the progress takes.
    auto* layout = columnOf(column, {m_ladderHeading, m_list, m_progressText, m_progress, m_measure});
    layout->setStretchFactor(m_list, 1);
    auto* all = new QHBoxLayout;
    all->addWidget(m_measureAll, 2);
    all->addWidget(m_cancel, 1);
    layout->addLayout(all);
    column->setMinimumWidth(base::em(this, 18));
    return column;
}

QWidget* CostPage::makeMiddle() {
    auto* middle = new QWidget(this);
    m_title = heading(middle, base::kLargeText);
    m_title->setObjectName(QStringLiteral("title"));
    m_truth = wrapped(middle);
    m_chart = new cost::CostChart(middle);
    m_words = wrapped(middle);
    m_words->setObjectName(QStringLiteral("words"));
    auto* charted = new QWidget(middle);
    auto* chartColumn = new QVBoxLayout(charted);
    chartColumn->setContentsMargins(0, 0, 0, 0);
    chartColumn->addWidget(m_chart, 1);
    chartColumn->addWidget(m_words);
    m_empty = new chrome::EmptyState(base::Icon::cost, middle);
    m_measureEmpty = m_empty->addAction(QString(), QString());
    m_measureEmpty->setObjectName(QStringLiteral("measureEmpty"));
    m_results = new QStackedWidget(middle);
    m_results->addWidget(m_empty);
    m_results->addWidget(charted);
    columnOf(middle, {m_title, m_truth, m_results})->setStretchFactor(m_results, 1);
    return middle;
}

QWidget* CostPage::makeTable() {
    m_below = new QWidget(this);
    m_table = base::named<QTableWidget>("rungs", 0, columns, m_below);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    // What is too long for its column has further lines.
    m_table->verticalHeader()->setMinimumSectionSize(base::em(this, 1.7));
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(m_table->horizontalHeader(), &QHeaderView::sectionResized, m_table,
            &QTableWidget::resizeRowsToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(parameterColumn, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(m_below);
    const int margin = base::grid(m_below, 2);
    layout->setContentsMargins(margin, 0, margin, margin);
    layout->addWidget(m_table);
    return m_below;
}

QWidget* CostPage::makeCameraColumn() {
    auto* column = new QWidget(this);
    m_cameraHeading = heading(column);
    m_rungLabel = new QLabel(column);
    m_rungs = base::named<QComboBox>("rung", column);
    for (const vision::ContactRung& rung : vision::contactLadder()) {
        const QString name = QString::fromUtf8(rung.name.data(), static_cast<qsizetype>(rung.name.size()));
        m_rungs->addItem(name, name);
    }
    m_rungLabel->setBuddy(m_rungs);
    m_stagesLabel = new QLabel(column);
    m_stages = new camera::StageBar(column);
    m_budgetLabel = new QLabel(column);
    m_budget_ms = base::named<QDoubleSpinBox>("budget", column);
    m_budget_ms->setRange(0.1, 10'000.0);
    m_budget_ms->setDecimals(1);
    m_budget_ms->setValue(kUsualBudget_ms);
    m_budgetLabel->setBuddy(m_budget_ms);
    m_budgetText = wrapped(column);
    m_useBest = base::named<QPushButton>("useBest", column);
    m_noCamera = wrapped(column);
    m_openCamera = new QPushButton(column);
    QVBoxLayout* layout =
        columnOf(column, {m_cameraHeading, m_noCamera, m_openCamera, m_rungLabel, m_rungs, m_stagesLabel,
                          m_stages, m_budgetLabel, m_budget_ms, m_budgetText, m_useBest});
    layout->insertSpacing(layout->indexOf(m_budgetLabel), base::grid(this, 2));
    layout->addStretch(1);
    column->setMinimumWidth(base::em(this, 17));
    return column;
}

std::string CostPage::ladderShown() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item == nullptr ? std::string() : item->data(Qt::UserRole).toString().toStdString();
}

QString CostPage::cameraJob() const {
    const auto& ladders = m_measuring->ladders();
    const auto job = std::ranges::find(ladders, kCameraLadder, &cost::Ladder::name);
    return job == ladders.end() ? QString::fromLatin1(kCameraLadder) : QString::fromStdString(job->title);
}

void CostPage::showLadders() {
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem* item = m_list->item(row);
        if (const QVariant topic = item->data(kTopicRole); topic.isValid()) {
            item->setText(CostWords::topic(static_cast<cost::Topic>(topic.toInt())));
            continue;
        }
        const std::string name = item->data(Qt::UserRole).toString().toStdString();
        const auto ladder = std::ranges::find(m_measuring->ladders(), name, &cost::Ladder::name);
        if (ladder == m_measuring->ladders().end())
            continue;
        const QString title = QString::fromStdString(ladder->title);
        const QString times = timesOf(m_measuring->costOf(name));
        item->setText(times.isEmpty() ? title : title + QLatin1Char('\n') + times);
        const QString known = times.isEmpty() ? tr("not measured") : times;
        item->setData(Qt::AccessibleDescriptionRole, known);
        item->setToolTip(known + QLatin1Char('\n') +
                         tr("On the command line: %1").arg(QString::fromStdString(name)));
    }
}

QString CostPage::timesOf(const cost::LadderCost* costs) {
    if (costs == nullptr || costs->rungs.empty())
        return {};
    const auto [least, most] = std::ranges::minmax(costs->rungs, {}, &cost::RungCost::timeMedian_s);
    return tr("%1 to %2", "times")
        .arg(CostWords::quantity(least.timeMedian_s, QStringLiteral("s")),
             CostWords::quantity(most.timeMedian_s, QStringLiteral("s")));
}

void CostPage::showCosts() {
    const std::string name = ladderShown();
    const auto& ladders = m_measuring->ladders();
    const auto ladder = std::ranges::find(ladders, name, &cost::Ladder::name);
    if (ladder == ladders.end())
        return;
    m_title->setText(QString::fromStdString(ladder->title));
    const cost::LadderCost* found = m_measuring->costOf(name);
    QString truth = tr("Error: %1.").arg(QString::fromStdString(ladder->truth));
    if (const auto over = found != nullptr ? cost::overLimit(found->rungs) : std::nullopt)
        truth +=
            QLatin1Char('\n') + tr("Fastest: %1, %2 times the limit (%3: %4).")
                                    .arg(QString::fromStdString(over->fastest->name),
                                         QLocale().toString(over->times, 'g', 3),
                                         QString::fromStdString(over->limit->parameter),
                                         CostWords::quantity(over->limit->timeMedian_s, QStringLiteral("s")));
    m_truth->setText(truth);
    const cost::LadderCost costs = found != nullptr ? *found : cost::LadderCost{name, ladder->errorUnit, {}};
    m_results->setCurrentIndex(found != nullptr ? 1 : 0);
    m_below->setVisible(found != nullptr);
    m_measure->setVisible(found != nullptr); // otherwise the middle has the button
    const QString unit = QString::fromStdString(costs.errorUnit);
    m_table->setRowCount(static_cast<int>(costs.rungs.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const cost::RungCost& rung = costs.rungs[static_cast<std::size_t>(row)];
        const QString rungName = QString::fromStdString(rung.name);
        const auto set = [&](int column, const QString& text, bool number) {
            auto* item = new QTableWidgetItem(text);
            item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
            if (rung.pareto) {
                QFont bold = m_table->font();
                bold.setBold(true);
                item->setFont(bold);
            }
            m_table->setItem(row, column, item);
        };
        set(rungColumn, rung.pareto ? tr("%1 (frontier)", "name of a setting").arg(rungName) : rungName,
            false);
        m_table->item(row, rungColumn)->setData(Qt::UserRole, rungName);
        set(parameterColumn, QString::fromStdString(rung.parameter), false);
        set(errorColumn, CostWords::quantity(rung.errorMean, unit), true);
        set(p95Column, CostWords::quantity(rung.errorP95, unit), true);
        set(worstColumn, CostWords::quantity(rung.errorMax, unit), true);
        set(timeColumn,
            rung.isTimed() ? CostWords::quantity(rung.timeMedian_s, QStringLiteral("s"))
                           : tr("refused: too noisy"),
            true);
        set(p99Column, CostWords::quantity(rung.timeP99_s, QStringLiteral("s")), true);
    }
    m_chart->setLadder(costs);
    m_chart->setRungInUse(name == kCameraLadder ? m_inUse : QString());
    showWords();
    showBudget();
    showRunning();
}

/// Of the setting that runs, or else of the chosen one.
void CostPage::showWords() {
    const cost::LadderCost* found = m_measuring->costOf(ladderShown());
    const QTableWidgetItem* chosen = m_table->item(m_table->currentRow(), rungColumn);
    const bool runs = ladderShown() == kCameraLadder && !m_inUse.isEmpty();
    const QString setting = chosen != nullptr ? chosen->data(Qt::UserRole).toString() : m_inUse;
    QString words;
    if (found != nullptr && runs)
        words = CostWords::about(*found, m_inUse.toStdString(), true);
    if (found != nullptr && chosen != nullptr && (!runs || setting != m_inUse))
        words += (words.isEmpty() ? QString() : QStringLiteral("\n")) +
                 CostWords::about(*found, setting.toStdString(), false);
    if (found != nullptr && words.isEmpty())
        words = tr("Choose a setting in the table or the chart to read what it costs and gives.");
    m_words->setText(words);
}

void CostPage::showRunning() {
    const bool running = m_measuring->isRunning();
    m_empty->setTexts(m_measuring->isMeasuring(ladderShown()) ? tr("Measuring")
                                                              : tr("Not measured on this machine"),
                      tr("Close other programs and sources first: their load makes the times unreliable."));
    m_measure->setEnabled(!running);
    m_measureAll->setEnabled(!running);
    m_measureEmpty->setEnabled(!running);
    m_cancel->setEnabled(running && !m_measuring->isCancelled());
    m_progress->setVisible(running);
    m_progressText->setVisible(running);
    if (running) {
        m_progressText->setText(m_measuring->isCancelled() ? tr("Stopping\u2026") : tr("Preparing\u2026"));
        return;
    }
    m_progress->setValue(0);
    m_progressText->clear();
}

void CostPage::showBudget() {
    const double budget_s = 1e-3 * m_budget_ms->value();
    const cost::LadderCost* costs = m_measuring->costOf(kCameraLadder);
    m_chart->setBudget(ladderShown() == kCameraLadder ? std::optional(budget_s) : std::nullopt);
    m_best.clear();
    if (costs == nullptr) {
        m_budgetText->setText(tr("Measure \"%1\" first.").arg(cameraJob()));
    } else if (const cost::RungCost* best = cost::bestWithin(costs->rungs, budget_s)) {
        m_best = QString::fromStdString(best->name);
        m_budgetText->setText(
            tr("%1: %2 on average, 99 of 100 frames within %3 (1640 x 1232 pixels).")
                .arg(m_best, CostWords::quantity(best->errorMean, QString::fromStdString(costs->errorUnit)),
                     CostWords::quantity(best->timeP99_s, QStringLiteral("s"))));
    } else {
        m_budgetText->setText(tr("No setting is fast enough: only one frame in 100 may take longer."));
    }
    m_useBest->setEnabled(m_camera != nullptr && !m_best.isEmpty());
}

void CostPage::chooseRung(const QString& name) {
    if (!m_camera)
        return;
    m_wish = name;
    m_camera->chooseRung(name.toStdString());
    m_rungs->setCurrentIndex(m_rungs->findData(name));
}

void CostPage::tick(const std::shared_ptr<pipeline::CameraChannel>& camera) {
    m_sweeps->tick();
    if (m_measuring->isRunning() && !m_measuring->isCancelled()) {
        const cost::MeasureProgress progress = m_measuring->progress();
        m_progress->setValue(static_cast<int>(std::lround(1000.0 * progress.share)));
        const QString ladder = QString::fromStdString(progress.ladder);
        if (!progress.rung.empty())
            m_progressText->setText(
                tr("Measuring %1: %2").arg(ladder, QString::fromStdString(progress.rung)));
        else if (!ladder.isEmpty())
            m_progressText->setText(tr("Preparing %1\u2026").arg(ladder));
    }
    const bool other = camera != m_camera;
    m_camera = camera;
    const bool has = m_camera != nullptr;
    if (other || m_cameraShown != has) {
        m_cameraShown = has;
        m_noCamera->setVisible(!has);
        m_openCamera->setVisible(!has);
        for (QWidget* widget : {static_cast<QWidget*>(m_rungLabel), static_cast<QWidget*>(m_rungs),
                                static_cast<QWidget*>(m_stagesLabel), static_cast<QWidget*>(m_stages)})
            widget->setVisible(has);
        m_wish.clear();
        showBudget();
    }
    QString inUse;
    if (has && m_camera->generation() > 0) {
        const pipeline::CameraSnapshot& snapshot = m_camera->snapshot();
        m_stages->setSnapshot(&snapshot, m_camera->description().nominalRate_Hz);
        inUse = QString::fromUtf8(snapshot.rung.data(), static_cast<qsizetype>(snapshot.rung.size()));
        const QString refused = QString::fromUtf8(snapshot.refusedRung.data(),
                                                  static_cast<qsizetype>(snapshot.refusedRung.size()));
        if (!m_wish.isEmpty() && m_wish == refused)
            m_messages->post({chrome::Message::Severity::error,
                              tr("The setting %1 cannot be used.").arg(refused),
                              QString::fromStdString(snapshot.whyRefused), QString()});
        if (inUse == m_wish || refused == m_wish)
            m_wish.clear();
        const QString shown = m_wish.isEmpty() ? inUse : m_wish;
        if (m_rungs->currentData().toString() != shown && !m_rungs->view()->isVisible())
            m_rungs->setCurrentIndex(m_rungs->findData(shown));
    }
    if (inUse != m_inUse) {
        m_inUse = inUse;
        m_chart->setRungInUse(ladderShown() == kCameraLadder ? m_inUse : QString());
        showWords();
    }
}

void CostPage::retranslate() {
    m_tabs->setTabText(0, tr("Settings"));
    m_tabs->setTabText(1, tr("Sweeps"));
    m_ladderHeading->setText(tr("Jobs"));
    m_list->setAccessibleName(tr("Jobs that can be done fast or accurately"));
    m_measure->setText(tr("&Measure again"));
    m_measureAll->setText(tr("Measure all &jobs"));
    m_measureAll->setToolTip(tr("Takes a few minutes; you can go on using the console"));
    m_cancel->setText(tr("&Cancel"));
    m_measureEmpty->setText(tr("Measure this job"));
    m_table->setHorizontalHeaderLabels({tr("Setting"), tr("Parameter"), tr("Mean error"), tr("95 %"),
                                        tr("Worst"), tr("Median time"), tr("99 % time")});
    m_table->setAccessibleName(tr("Settings with their errors and times"));
    m_cameraHeading->setText(tr("Camera in use"));
    m_rungLabel->setText(tr("&Setting in use"));
    m_rungs->setAccessibleName(tr("Setting that finds the contacts"));
    m_stagesLabel->setText(tr("Time of a frame, now"));
    m_budgetLabel->setText(tr("&Time budget of a frame"));
    m_budget_ms->setSuffix(tr(" ms a frame"));
    m_useBest->setText(tr("&Use the best setting within it"));
    m_noCamera->setText(tr("No camera is shown on the page Operate."));
    m_openCamera->setText(tr("Open a demo with a camera"));
    showLadders();
    showCosts();
}

} // namespace teleta::console
