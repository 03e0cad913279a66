// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/plot_page.h"

#include "backend/signal/signal_csv.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/controls/elided_label.h"
#include "widgets/base/controls/find_shortcut.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/empty_state.h"
#include "widgets/signal/signal_drop_area.h"
#include "widgets/signal/signal_plot.h"
#include "widgets/signal/signal_table.h"
#include "widgets/signal/signal_tree.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace teleta::console {

namespace {

constexpr int kValues_ms = 250;  ///< between two paintings of newest values
constexpr int kSpectra_ms = 500; ///< between two computations of spectra
constexpr double kUsualSpan_s = 10.0;

} // namespace

PlotPage::PlotPage(SourceManager& sources, ConsoleSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_signals(new PlotSignals(sources, this))
    , m_messages(new chrome::MessageBar(this))
    , m_layouts(new PlotLayoutsMenu(
          settings, [this] { return layoutNow(); }, this))
    , m_undo(new QAction(this)) {
    auto* split = new QSplitter(this);
    split->setChildrenCollapsible(false);
    split->addWidget(makeSignalColumn());
    split->addWidget(makeMiddle());
    split->setStretchFactor(1, 1);
    split->setSizes({base::em(this, 20), base::em(this, 70)});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(split, 1);
    m_undo->setShortcut(QKeySequence::Undo);
    m_undo->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(m_undo);
    base::findBy(&m_tree->search(), this);
    connectViews();
    base::keepTranslated(this, &PlotPage::retranslate);
    showSources();
    showSignals();
}

QWidget* PlotPage::makeSignalColumn() {
    auto* column = new QWidget(this);
    m_tree = new signal::SignalTree(column);
    m_addRecording = base::named<QPushButton>("addRecording", column);
    m_progress = new QProgressBar(column);
    m_progress->setRange(0, 1000);
    m_progress->hide();
    m_cancelReading = base::named<QToolButton>("cancelReading", column);
    m_cancelReading->hide();
    auto* reading = new QHBoxLayout;
    base::addWidgets(reading, {m_progress, m_cancelReading});
    auto* layout = new QVBoxLayout(column);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(margin);
    layout->addWidget(m_tree, 1);
    layout->addLayout(reading);
    layout->addWidget(m_addRecording);
    column->setMinimumWidth(base::em(this, 15));
    return column;
}

QWidget* PlotPage::makeToolBar() {
    auto* bar = new QWidget(this);
    m_follow = base::named<QCheckBox>("plotFollow", bar);
    m_everything = base::named<QToolButton>("everything", bar);
    m_cursors = base::named<QCheckBox>("cursors", bar);
    m_density = base::named<QCheckBox>("density", bar);
    m_layoutsButton = base::named<QToolButton>("plotLayouts", bar);
    m_layoutsButton->setMenu(m_layouts);
    m_layoutsButton->setPopupMode(QToolButton::InstantPopup);
    m_saveButton = base::named<QToolButton>("savePlot", bar);
    m_saveMenu = new QMenu(this);
    m_saveButton->setMenu(m_saveMenu);
    m_saveButton->setPopupMode(QToolButton::InstantPopup);
    m_time = base::named<QComboBox>("plotTime", bar);
    m_time->addItems({QString(), QString()});
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this),
                               base::grid(this, 0.5));
    layout->setSpacing(base::grid(this));
    base::addWidgets(layout, {m_everything, m_follow, m_cursors, m_time, m_density});
    layout->addStretch(1);
    base::addWidgets(layout, {m_layoutsButton, m_saveButton});
    return bar;
}

/// What is to be known of the signals in view.
QWidget* PlotPage::makeStatusLine() {
    m_status = new QWidget(this);
    auto* layout = new QHBoxLayout(m_status);
    layout->setContentsMargins(base::grid(this), 0, base::grid(this), base::grid(this, 0.5));
    layout->setSpacing(base::grid(this));
    for (std::size_t i = 0; i < m_badges.size(); ++i) {
        m_badges[i] = new base::ProvenanceBadge(m_status);
        m_badges[i]->setObjectName(i == 0 ? QStringLiteral("plotProvenance")
                                          : QStringLiteral("plotProvenance%1").arg(i));
        layout->addWidget(m_badges[i]);
    }
    m_state = new base::ElidedLabel(m_status);
    m_state->setObjectName(QStringLiteral("plotState"));
    m_state->setMinimumHeight(base::em(this, 1.5));
    layout->addWidget(m_state, 1);
    return m_status;
}

QWidget* PlotPage::makeMiddle() {
    auto* middle = new QWidget(this);
    auto* area = base::named<signal::SignalDropArea>("dropArea", middle);
    m_plot = new signal::SignalPlot;
    m_table = new signal::SignalTable;
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(m_plot);
    parts->addWidget(m_table);
    parts->setStretchFactor(0, 1);
    parts->setSizes({base::em(this, 30), base::em(this, 9)});
    m_empty = new chrome::EmptyState(base::Icon::plot);
    auto* demo = m_empty->addAction(QString(), QString());
    demo->setObjectName(QStringLiteral("plotDemo"));
    auto* recording = m_empty->addAction(QString(), QString());
    recording->setObjectName(QStringLiteral("plotRecording"));
    m_stack = new QStackedWidget;
    m_stack->addWidget(m_empty);
    m_stack->addWidget(parts);
    auto* inside = new QVBoxLayout(area);
    inside->setContentsMargins(2, 2, 2, 2);
    inside->addWidget(m_stack);
    auto* layout = new QVBoxLayout(middle);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeToolBar());
    layout->addWidget(makeStatusLine());
    layout->addWidget(area, 1);
    connect(demo, &QPushButton::clicked, this, &PlotPage::demoRequested);
    connect(recording, &QPushButton::clicked, this, &PlotPage::askForRecording);
    connect(area, &signal::SignalDropArea::dropped, m_signals, &PlotSignals::add);
    return middle;
}

void PlotPage::connectViews() {
    const auto report = [this](const QString& what, const QString& details) {
        m_messages->post({chrome::Message::Severity::error, what, QString(), details});
    };
    connect(m_tree, &signal::SignalTree::chosen, m_signals, &PlotSignals::add);
    m_tree->setValues([this](const signal::SignalId& id) { return valueText(id); });
    connect(m_addRecording, &QPushButton::clicked, this, &PlotPage::askForRecording);
    connect(m_cancelReading, &QToolButton::clicked, m_signals, &PlotSignals::cancelReading);
    connect(m_signals, &PlotSignals::changed, this, &PlotPage::showSignals);
    connect(m_signals, &PlotSignals::recordingRead, this, [this] {
        // A recording as a whole, unless something that runs is looked at.
        const auto& shown = m_signals->shown();
        const bool anyLive = std::ranges::any_of(shown, [this](const auto& each) {
            const auto found = m_signals->sources().find(each.what.id);
            return found && !found->isRecorded;
        });
        if (!anyLive && m_plot->isFollowing())
            m_plot->showEverything();
    });
    connect(&m_signals->sources(), &SignalSources::changed, this, &PlotPage::showSources);
    connect(&m_signals->sources(), &SignalSources::failed, this,
            [report](const QString& name, const QString& why) {
                report(tr("%1 could not be read.", "a recording").arg(name), why);
            });
    connect(&m_signals->sources(), &SignalSources::readFailed, this,
            [report](const signal::SignalId& id, const QString& why) {
                report(tr("%1 could not be read.", "a recording").arg(QString::fromStdString(id.source)),
                       why);
            });
    connect(&m_signals->sources(), &SignalSources::damaged, this, [this](const QString& name, int blocks) {
        m_messages->post(
            {chrome::Message::Severity::warning,
             tr("%1 is damaged: %n part(s) could not be read and are gaps.", nullptr, blocks).arg(name),
             QString(), QString()});
    });
    connect(m_table, &signal::SignalTable::removeRequested, m_signals, &PlotSignals::remove);
    connect(m_table, &signal::SignalTable::derivativeRequested, m_signals, &PlotSignals::addDerivative);
    connect(m_table, &signal::SignalTable::spectrumRequested, m_signals, &PlotSignals::setSpectrum);
    connect(m_undo, &QAction::triggered, m_signals, &PlotSignals::undoRemove);
    connect(m_plot, &signal::SignalPlot::menuRequested, this, &PlotPage::popUpMenu);
    connect(m_plot, &signal::SignalPlot::followingChanged, m_follow, &QCheckBox::setChecked);
    connect(m_plot, &signal::SignalPlot::cursorsChanged, this, &PlotPage::showReadings);
    connect(m_plot, &signal::SignalPlot::exportFailed, this,
            [report](const QString& message) { report(message, QString()); });
    connect(m_follow, &QCheckBox::toggled, m_plot, &signal::SignalPlot::setFollowing);
    connect(m_everything, &QToolButton::clicked, m_plot, &signal::SignalPlot::showEverything);
    connect(m_cursors, &QCheckBox::toggled, m_plot, &signal::SignalPlot::setCursors);
    connect(m_density, &QCheckBox::toggled, m_plot, &signal::SignalPlot::setDensity);
    connect(m_time, &QComboBox::currentIndexChanged, this, [this](int index) { setClockTime(index == 1); });
    connect(m_layouts, &PlotLayoutsMenu::chosen, this, &PlotPage::restore);
    connect(m_layouts, &PlotLayoutsMenu::notRestored, this, [this](const QString& name) {
        m_messages->post({chrome::Message::Severity::warning,
                          tr("The layout %1 cannot be restored.").arg(name),
                          tr("It was saved by another version of the program."), QString()});
    });
    connect(m_saveMenu, &QMenu::aboutToShow, this, [this] {
        m_saveMenu->clear();
        m_plot->addPictureActions(*m_saveMenu);
        m_saveMenu->addAction(tr("Save da&ta\u2026"), this, &PlotPage::askForData);
    });
}

void PlotPage::retranslate() {
    m_addRecording->setText(tr("A&dd a recording\u2026"));
    m_addRecording->setToolTip(tr("Plot a recording as a whole, without playing it"));
    m_progress->setFormat(tr("Reading: %p %"));
    m_cancelReading->setText(tr("Cancel"));
    m_cancelReading->setToolTip(tr("Stop reading and remove these signals; Ctrl+Z reads them again"));
    m_follow->setText(tr("Follow"));
    m_follow->setToolTip(tr("The newest sample stays at the right end (Space, End)"));
    m_everything->setText(tr("Show everything"));
    m_everything->setToolTip(tr("All samples, and axes that follow the values (Home, double click)"));
    m_cursors->setText(tr("Cursors"));
    m_cursors->setToolTip(tr("Two lines to measure between (C); Left and Right move A, with Ctrl B"));
    m_time->setItemText(0, tr("From each start"));
    m_time->setItemText(1, tr("Clock time"));
    m_time->setAccessibleName(tr("Time axis"));
    m_time->setToolTip(tr("Where the time axis begins: with each source, so that a recording lies upon what "
                          "runs, or by the clock"));
    m_density->setText(tr("Power density"));
    m_density->setToolTip(tr("Spectra show the density of power instead of the amplitude"));
    m_layoutsButton->setText(tr("Layouts"));
    m_layoutsButton->setToolTip(tr("Save what is plotted under a name, and choose it again"));
    m_saveButton->setText(tr("Save"));
    m_saveButton->setToolTip(tr("The picture, or the samples in view as CSV"));
    m_undo->setText(tr("Undo remove"));
    m_empty->setTexts(tr("Nothing is plotted yet"),
                      tr("Drag a signal from the list onto this place, or choose it there and press Enter."));
    m_empty->setAction("plotDemo", tr("Open a demo"), tr("A simulated arm that touches things"));
    m_empty->setAction("plotRecording", tr("Add a recording\u2026"),
                       tr("Plot a recording as a whole, without playing it"));
    showSources();
    showSignals();
}

QString PlotPage::newestText(double value) {
    // Lengths are in metres: two decimals would make nothing of them.
    constexpr double kSmall = 0.1;
    return std::abs(value) < kSmall ? base::significantDigits(value, 3) : base::threeDigits(value);
}

QString PlotPage::valueText(const signal::SignalId& id) const {
    const auto found = m_signals->sources().find(id);
    return found && found->newest ? newestText(*found->newest) : QString();
}

void PlotPage::showSources() {
    m_tree->setSources(m_signals->sources().entries());
}

void PlotPage::showSignals() {
    std::vector<signal::PlotCurve> curves;
    std::vector<signal::SignalRow> rows;
    for (const PlotSignals::Shown& each : m_signals->shown()) {
        curves.push_back({each.name(), each.shownUnit(), each.colour, each.series(), each.spectrum,
                          each.isOfEvents, m_signals->shift_s(each), !each.isRecorded});
        const QString note = each.note.isEmpty() ? each.spectrumNote : each.note;
        rows.push_back(
            {each.name(), note, each.shownUnit(), each.colour, each.what.derivative, each.what.spectrum});
    }
    m_table->setRows(rows);
    m_plot->setCurves(std::move(curves));
    std::vector<base::Provenance> provenances = m_signals->provenances();
    provenances.resize(m_badges.size(), base::Provenance::live);
    m_plot->setProvenance(provenances.front());
    for (std::size_t i = 0; i < m_badges.size(); ++i)
        m_badges[i]->setProvenance(provenances[i]);
    const bool has = !rows.empty();
    if (has && !std::exchange(m_hadSignals, true)) {
        m_plot->setRange(-kUsualSpan_s, 0.0);
        m_plot->setFollowing(true);
    }
    m_hadSignals = has;
    m_stack->setCurrentIndex(has ? 1 : 0);
    m_status->setVisible(has);
    m_density->setVisible(std::ranges::any_of(rows, &signal::SignalRow::hasSpectrum));
    m_undo->setEnabled(m_signals->canUndo());
    for (auto* button :
         std::initializer_list<QAbstractButton*>{m_follow, m_everything, m_cursors, m_saveButton})
        button->setEnabled(has);
    showReadings();
    showProgress();
}

void PlotPage::showReadings() {
    const auto cursors = m_plot->cursors_s();
    m_cursors->setChecked(cursors.has_value());
    std::vector<signal::SignalReading> readings;
    for (const PlotSignals::Shown& each : m_signals->shown()) {
        const auto series = each.series();
        if (!series)
            readings.emplace_back();
        else if (cursors)
            readings.push_back({series->at((*cursors)[0] - m_signals->shift_s(each)),
                                series->at((*cursors)[1] - m_signals->shift_s(each))});
        else
            readings.push_back({series->newest(), std::nullopt});
    }
    m_table->setReadings(readings, cursors ? std::optional((*cursors)[1] - (*cursors)[0]) : std::nullopt);
}

void PlotPage::showProgress() {
    const auto progress = m_signals->sources().progress();
    m_progress->setVisible(progress.has_value());
    m_cancelReading->setVisible(progress.has_value());
    if (progress)
        m_progress->setValue(static_cast<int>(std::lround(1000.0 * *progress)));
}

void PlotPage::showState() {
    showProgress();
    QStringList parts;
    if (const int outside = outsideView(); outside > 0)
        parts << tr("%n signal(s) outside the view: Show everything (Home)", nullptr, outside);
    if (const std::uint64_t dropped = m_signals->dropped(); dropped > 0)
        parts << tr("%1 old samples dropped").arg(base::shortCount(dropped));
    if (const std::uint64_t lost = m_signals->sources().lost(); lost > 0)
        parts << tr("%1 frames lost").arg(base::shortCount(lost));
    const QString text = parts.join(QStringLiteral(", "));
    if (m_state->text() != text)
        m_state->setText(text);
}

int PlotPage::outsideView() const {
    return static_cast<int>(std::ranges::count_if(m_signals->shown(), [this](const auto& each) {
        const auto series = each.series();
        const double shift_s = m_signals->shift_s(each);
        return series && !series->empty() &&
               (series->time_s(series->size() - 1) + shift_s < m_plot->from_s() ||
                series->time_s(0) + shift_s > m_plot->to_s());
    }));
}

void PlotPage::setClockTime(bool clock) {
    m_signals->setClockTime(clock);
    m_plot->setClockTime(clock);
    m_plot->setCursors(false); // of another time
    if (!m_plot->isFollowing())
        m_plot->showEverything();
}

void PlotPage::refreshSpectra() {
    const auto& shown = m_signals->shown();
    std::uint64_t appended = 0;
    bool isMissing = false;
    for (const auto& each : shown) {
        if (!each.what.spectrum || !each.series())
            continue;
        appended += 1 + each.series()->appended();
        isMissing = isMissing || (!each.spectrum && each.spectrumNote.isEmpty());
    }
    const std::pair range(m_plot->from_s(), m_plot->to_s());
    if (appended == 0 || (m_spectraComputed.isValid() && m_spectraComputed.elapsed() < kSpectra_ms) ||
        (range == m_spectraOf && appended == m_spectraAppended && !isMissing))
        return;
    m_spectraOf = range;
    m_spectraAppended = appended;
    m_spectraComputed.start();
    m_signals->computeSpectra(range.first, range.second);
}

void PlotPage::tick() {
    m_signals->tick();
    if (!isVisible())
        return;
    m_plot->refresh();
    refreshSpectra();
    if (m_valuesShown.isValid() && m_valuesShown.elapsed() < kValues_ms)
        return;
    m_valuesShown.start();
    m_tree->refreshValues();
    showReadings();
    showState();
}

void PlotPage::askForRecording() {
    base::askToOpen(this, {.title = tr("Add a recording"), .filters = {tr("Recordings (*.teleta)")}},
                    [this](const QString& path) { m_signals->sources().addRecording(path); });
}

void PlotPage::askForData() {
    base::askToSave(this,
                    {.title = tr("Save data"),
                     .filters = {tr("Comma-separated values (*.csv)")},
                     .folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                     .suffix = QStringLiteral("csv"),
                     .name = tr("plot", "name of a file")},
                    [this](const QString& path) { saveData(path); });
}

void PlotPage::saveData(const QString& path) {
    base::runInBackground(
        this,
        [columns = m_signals->forCsv(), file = path.toStdString(), from_s = m_plot->from_s(),
         to_s = m_plot->to_s(), time = m_time->currentIndex() == 1 ? "utc_s" : "time_s"] {
            return signal::writeSignalCsv(file, columns, from_s, to_s, time);
        },
        [this, path](const core::Expected<void>& written) {
            if (written)
                m_messages->post({chrome::Message::Severity::information, tr("The data were saved."),
                                  QDir::toNativeSeparators(path), QString()});
            else
                m_messages->post({chrome::Message::Severity::error, tr("The data could not be saved."),
                                  tr("Choose another folder or file name."),
                                  QString::fromStdString(core::describe(written.error()))});
        });
}

void PlotPage::popUpMenu(const QPoint& global) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(m_everything->text(), m_plot, &signal::SignalPlot::showEverything);
    menu->addAction(m_cursors->text(), m_cursors, &QCheckBox::toggle);
    if (m_signals->canUndo())
        menu->addAction(m_undo);
    menu->addSeparator();
    m_plot->addPictureActions(*menu);
    menu->addAction(tr("Save da&ta\u2026"), this, &PlotPage::askForData);
    menu->popup(global);
}

void PlotPage::plotNamed(const QStringList& names) {
    PlotLayout layout;
    for (const QString& name : names)
        layout.plotted.push_back({.id = {name.section(QLatin1Char('/'), 0, 0).toStdString(),
                                         name.section(QLatin1Char('/'), 1, -2).toStdString(),
                                         name.section(QLatin1Char('/'), -1).toStdString()}});
    restore(layout);
}

PlotLayout PlotPage::layoutNow() const {
    return {m_signals->plotted(), m_plot->span_s(), m_density->isChecked(), m_time->currentIndex() == 1};
}

void PlotPage::restore(const PlotLayout& layout) {
    m_signals->set(layout.plotted);
    m_density->setChecked(layout.density);
    m_time->setCurrentIndex(layout.clock ? 1 : 0);
    const double end_s = m_plot->to_s();
    const bool followed = m_plot->isFollowing();
    m_plot->setRange(end_s - layout.span_s, end_s);
    m_plot->setFollowing(followed);
}

} // namespace teleta::console
