// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/cost/sweep_panel.h"

#include "app/common/duration_text.h"
#include "app/common/scene_file.h"
#include "app/console/cost/apart_items.h"
#include "app/console/cost/sweep_texts.h"
#include "backend/sweep/sweep_figure.h"
#include "widgets/base/compose.h"
#include "widgets/base/figure/svg_view.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/rows_html.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/empty_state.h"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

/// Of the heading of a topic: a sweep of it.
constexpr int kOfTopicRole = Qt::UserRole + 1;
/// Rows of the table; runs.csv and cells.csv have all.
constexpr int kMostRows = 2000;

QString numberText(const std::optional<double>& value) {
    return value ? QLocale().toString(*value, 'g', 4) : QStringLiteral("\u2014");
}

} // namespace

SweepPanel::SweepPanel(SweepRunning::MakeSources makeSources, QWidget* parent)
    : QWidget(parent)
    , m_running(new SweepRunning(std::move(makeSources), this)) {
    auto* split = new QSplitter(this);
    split->setChildrenCollapsible(false);
    split->addWidget(makeListColumn());
    split->addWidget(makeMiddle());
    split->setStretchFactor(1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(split);

    connect(m_running, &SweepRunning::shownChanged, this, &SweepPanel::showSweep);
    connect(m_running, &SweepRunning::runningChanged, this, &SweepPanel::showRunning);
    connect(m_running, &SweepRunning::failed, this, &SweepPanel::failed);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item != nullptr)
            m_running->open(item->data(Qt::UserRole).toString());
    });
    connect(m_open, &QPushButton::clicked, this, &SweepPanel::askToOpen);
    connect(m_openResults, &QPushButton::clicked, this, [this] {
        base::askForFolder(this, {.title = tr("Open the results of a sweep")},
                           [this](const QString& folder) { m_running->open(folder); });
    });
    connect(m_start, &QPushButton::clicked, this, &SweepPanel::askToStart);
    connect(m_startEmpty, &QPushButton::clicked, this, [this] { m_running->start(newFolder()); });
    connect(m_cancel, &QPushButton::clicked, m_running, &SweepRunning::cancel);
    connect(m_measure, &QComboBox::currentIndexChanged, this, &SweepPanel::showMeasure);
    connect(m_picture, &base::SvgView::exportFailed, this,
            [this](const QString& message) { emit failed(message, QString()); });
    retranslate();
    showRunning();
}

QWidget* SweepPanel::makeListColumn() {
    auto* column = new QWidget(this);
    m_heading = new QLabel(column);
    m_heading->setFont(base::bold(base::sized(font(), base::kTitleText)));
    m_list = base::named<QListWidget>("sweeps", column);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setItemDelegate(new ApartItems(m_list));
    fillList();
    m_open = base::named<QPushButton>("openSweep", column);
    m_openResults = base::named<QPushButton>("openResults", column);
    m_start = base::named<QPushButton>("startSweep", column);
    m_cancel = base::named<QPushButton>("cancelSweep", column);
    m_progress = new QProgressBar(column);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progressText = new QLabel(column);
    m_progressText->setWordWrap(true);
    for (QWidget* widget : {static_cast<QWidget*>(m_cancel), static_cast<QWidget*>(m_progress)}) {
        QSizePolicy policy = widget->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        widget->setSizePolicy(policy);
    }
    auto* layout = new QVBoxLayout(column);
    const int margin = base::grid(column, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(column));
    base::addWidgets(
        layout, {m_heading, m_list, m_open, m_openResults, m_start, m_progressText, m_progress, m_cancel});
    layout->setStretchFactor(m_list, 1);
    column->setMinimumWidth(base::em(this, 18));
    return column;
}

/// Those of a topic below its heading, in the order in which each topic is first met.
void SweepPanel::fillList() {
    QStringList left = app::sweepNames();
    while (!left.isEmpty()) {
        const QString topic = sweepText(left.front()).topic;
        if (!topic.isEmpty()) {
            ApartItems::addHeading(*m_list)->setData(kOfTopicRole, left.front());
        }
        left.removeIf([&](const QString& name) {
            if (sweepText(name).topic != topic)
                return false;
            auto* item = new QListWidgetItem(m_list);
            item->setData(Qt::UserRole, name);
            return true;
        });
    }
}

QWidget* SweepPanel::makeMiddle() {
    auto* middle = new QWidget(this);
    m_title = base::named<QLabel>("sweepTitle", middle);
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_about = new QLabel(middle);
    m_about->setWordWrap(true);
    m_measureLabel = new QLabel(middle);
    m_measure = base::named<QComboBox>("sweepMeasure", middle);
    m_measureLabel->setBuddy(m_measure);
    auto* choice = new QHBoxLayout;
    choice->addWidget(m_measureLabel);
    choice->addWidget(m_measure, 1);
    m_picture = base::named<base::SvgView>("sweepPicture", middle);
    m_table = base::named<QTableWidget>("sweepCells", middle);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(base::em(this, 1.7));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* parts = new QSplitter(Qt::Vertical, middle);
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_picture);
    parts->addWidget(m_table);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 1);
    auto* results = new QWidget(middle);
    auto* resultsLayout = new QVBoxLayout(results);
    resultsLayout->setContentsMargins(0, 0, 0, 0);
    resultsLayout->addLayout(choice);
    resultsLayout->addWidget(parts, 1);
    m_plan = base::named<QLabel>("sweepPlan", middle);
    m_plan->setTextFormat(Qt::RichText);
    m_plan->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_plan->setWordWrap(true);
    m_empty = new chrome::EmptyState(base::Icon::cost, middle);
    m_startEmpty = m_empty->addAction(QString(), QString());
    m_startEmpty->setObjectName(QStringLiteral("startSweepEmpty"));
    auto* before = new QWidget(middle);
    auto* beforeLayout = new QVBoxLayout(before);
    beforeLayout->setContentsMargins(0, 0, 0, 0);
    beforeLayout->addWidget(m_plan);
    beforeLayout->addWidget(m_empty, 1);
    m_pages = new QStackedWidget(middle);
    m_pages->addWidget(before);
    m_pages->addWidget(results);
    auto* layout = new QVBoxLayout(middle);
    const int margin = base::grid(middle, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(middle));
    base::addWidgets(layout, {m_title, m_about, m_pages});
    layout->setStretchFactor(m_pages, 1);
    return middle;
}

void SweepPanel::askToOpen() {
    base::askToOpen(this, {.title = tr("Open a sweep"), .filters = {tr("Sweeps (*.toml)")}},
                    [this](const QString& path) { m_running->open(path); });
}

/// Among the documents, with the time in its name.
QString SweepPanel::newFolder() const {
    const QString name = QFileInfo(QString::fromStdString(m_running->shown()->plan.file)).completeBaseName();
    return QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .filePath(QStringLiteral("TeleTA/sweeps/") + name +
                  QDateTime::currentDateTime().toString(QStringLiteral("-yyyyMMdd'T'HHmmss")));
}

void SweepPanel::askToStart() {
    base::askForFolder(this,
                       {.title = tr("Empty folder for the results, or one of this sweep to go on with")},
                       [this](const QString& folder) { m_running->start(folder); });
}

void SweepPanel::showSweep() {
    const ShownSweep* shown = m_running->shown();
    const bool has = shown != nullptr && shown->results && !shown->results->measures.empty();
    const QString before = m_measure->currentText();
    const QSignalBlocker quiet(m_measure);
    m_measure->clear();
    if (shown != nullptr) {
        const SweepText text =
            sweepText(QFileInfo(QString::fromStdString(shown->plan.file)).completeBaseName());
        m_title->setText(text.about.isEmpty() ? QString::fromStdString(shown->plan.subject) : text.title);
        QString about = text.about.isEmpty() ? QString() : text.about + QLatin1Char('\n');
        about += shown->plan.kind == sweep::SubjectKind::ladder
                     ? tr("Every rung with %1 seeds.").arg(shown->plan.seeds())
                 : shown->plan.cells() == 1 ? tr("%1 runs, one for each seed.").arg(shown->plan.runs())
                                            : tr("%1 cells, each with %2 seeds: %3 runs.")
                                                  .arg(shown->plan.cells())
                                                  .arg(shown->plan.seeds())
                                                  .arg(shown->plan.runs());
        if (shown->results)
            about += QLatin1Char(' ') + tr("%1 done, %2 failed, in %3.")
                                            .arg(shown->results->done)
                                            .arg(shown->results->failed)
                                            .arg(shown->folder);
        m_about->setText(about);
        m_plan->setText(planText(shown->plan));
        if (has)
            for (const std::string& measure : shown->results->measures)
                m_measure->addItem(QString::fromStdString(measure));
    }
    m_measure->setCurrentIndex(std::max(0, m_measure->findText(before)));
    m_pages->setCurrentIndex(has ? 1 : 0);
    showMeasure();
    showRunning();
}

QString SweepPanel::planText(const sweep::SweepPlan& plan) {
    constexpr std::size_t kMostValues = 12;
    std::vector<std::pair<QString, QString>> rows;
    rows.emplace_back(plan.kind == sweep::SubjectKind::scene   ? tr("Scene")
                      : plan.kind == sweep::SubjectKind::study ? tr("Protocol")
                                                               : tr("Ladder"),
                      QString::fromStdString(plan.subject));
    for (const sweep::SweepAxis& axis : plan.axes) {
        QStringList values;
        for (std::size_t i = 0; i < std::min(axis.values.size(), kMostValues); ++i)
            values << sweep::valueText(axis, i);
        if (axis.values.size() > kMostValues)
            values << QStringLiteral("\u2026 ") + sweep::valueText(axis, axis.values.size() - 1);
        rows.emplace_back(sweep::axisTitle(axis), values.join(QStringLiteral(", ")));
    }
    QStringList measures;
    for (const std::string& measure : plan.measures)
        measures << QString::fromStdString(measure);
    rows.emplace_back(tr("Measured"),
                      measures.isEmpty() ? tr("all numbers of a run") : measures.join(QStringLiteral(", ")));
    return base::rowsHtml(rows);
}

void SweepPanel::showMeasure() {
    const ShownSweep* shown = m_running->shown();
    const int index = m_measure->currentIndex();
    if (shown == nullptr || !shown->results || index < 0) {
        m_picture->setPicture(std::nullopt);
        m_table->setRowCount(0);
        return;
    }
    const sweep::SweepPlan& plan = shown->plan;
    const sweep::SweepResults& results = *shown->results;
    const auto measure = static_cast<std::size_t>(index);
    if (auto picture = sweep::sweepFigure(plan, results, measure))
        m_picture->setPicture(base::SvgView::Picture{
            m_measure->currentText(), tr("%1 over the cells of the sweep").arg(m_measure->currentText()),
            std::move(*picture), QString()});
    else
        m_picture->setPicture(std::nullopt);
    QStringList headers;
    for (const sweep::SweepAxis& axis : plan.axes)
        headers << sweep::axisTitle(axis);
    headers << tr("Runs") << tr("Failed") << tr("Mean") << tr("Spread") << tr("95 % from") << tr("95 % to");
    m_table->setColumnCount(static_cast<int>(headers.size()));
    m_table->setHorizontalHeaderLabels(headers);
    m_table->setRowCount(std::min<int>(kMostRows, static_cast<int>(results.cells.size())));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const sweep::CellResult& cell = results.cells[static_cast<std::size_t>(row)];
        const sweep::CellMeasure& value = cell.measures[measure];
        int column = 0;
        const auto set = [&](const QString& text) {
            auto* item = new QTableWidgetItem(text);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column++, item);
        };
        const std::vector<std::size_t> place = plan.placeOf(cell.cell);
        for (std::size_t i = 0; i < place.size(); ++i)
            set(sweep::valueText(plan.axes[i], place[i]));
        set(QString::number(cell.runs));
        set(QString::number(cell.failed));
        set(numberText(value.mean));
        set(numberText(value.sd));
        set(numberText(value.low95));
        set(numberText(value.high95));
    }
}

void SweepPanel::showRunning() {
    const bool running = m_running->isRunning();
    m_start->setEnabled(!running && m_running->shown() != nullptr);
    m_startEmpty->setEnabled(m_start->isEnabled());
    m_startEmpty->setVisible(m_running->shown() != nullptr);
    m_list->setEnabled(!running);
    m_open->setEnabled(!running);
    m_openResults->setEnabled(!running);
    m_cancel->setVisible(running);
    m_cancel->setEnabled(!m_running->isCancelled());
    m_progress->setVisible(running);
    if (!running) {
        m_progress->setValue(0);
        m_progressText->clear();
    } else {
        m_progressText->setText(m_running->isCancelled() ? tr("The runs that are under way end\u2026")
                                                         : tr("Checking every cell\u2026"));
    }
    if (m_running->shown() == nullptr)
        m_empty->setTexts(tr("No sweep is open"), tr("Choose one on the left, or open a file."));
    else
        m_empty->setTexts(tr("No results yet"),
                          tr("A sweep runs a scene over a grid of settings and seeds, and keeps every run."));
}

void SweepPanel::tick() {
    if (m_running->isCancelled())
        return;
    const auto progress = m_running->progress();
    if (!progress || progress->all == 0)
        return;
    m_progress->setValue(static_cast<int>(1000 * progress->done / progress->all));
    m_progressText->setText(tr("%1 of %2 runs, %3 failed, %4 left")
                                .arg(progress->done)
                                .arg(progress->all)
                                .arg(progress->failed)
                                .arg(app::durationText(progress->left_s)));
}

void SweepPanel::retranslate() {
    m_heading->setText(tr("Sweeps"));
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem& item = *m_list->item(row);
        const QVariant topic = item.data(kOfTopicRole);
        item.setText(topic.isValid() ? sweepText(topic.toString()).topic
                                     : sweepText(item.data(Qt::UserRole).toString()).title);
    }
    m_list->setAccessibleName(tr("Sweeps that come with the program"));
    m_open->setText(tr("&Open a sweep\u2026"));
    m_openResults->setText(tr("Open resu&lts\u2026"));
    m_start->setText(tr("&Start in\u2026"));
    m_startEmpty->setText(tr("Start the sweep"));
    m_startEmpty->setToolTip(tr("Results are kept in a new folder in your documents"));
    m_cancel->setText(tr("&Cancel"));
    m_measureLabel->setText(tr("&Measure"));
    m_picture->setAccessibleName(tr("Chart of a measure over the cells"));
    m_table->setAccessibleName(tr("Cells with their settings and the measure"));
    showSweep();
}

} // namespace teleta::console
