// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/feedback_panel.h"

#include "backend/pattern/model/built_in_patterns.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/touch/touch_texts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <deque>
#include <utility>

namespace teleta::console {

using pipeline::FeedbackMode;

namespace {

QString timeText(double time_s) {
    return base::siQuantity(time_s, QStringLiteral("s")).trimmed();
}

/// With the bound of another clock.
QString timeText(double time_s, const std::optional<double>& bound_s) {
    return bound_s ? QStringLiteral("%1 ± %2").arg(timeText(time_s), timeText(*bound_s)) : timeText(time_s);
}

} // namespace

FeedbackPanel::FeedbackPanel(BraceletService& station, QWidget* parent)
    : QWidget(parent)
    , m_station(station)
    , m_modeLabel(new QLabel(this))
    , m_mode(new QComboBox(this))
    , m_last(new QLabel(this))
    , m_latency(new QLabel(this))
    , m_save(base::named<QPushButton>("saveTouchTimes", this))
    , m_table(new touch::PatternMapTable(this)) {
    m_modeLabel->setBuddy(m_mode);
    m_last->setWordWrap(true);
    m_latency->setWordWrap(true);
    m_latency->hide();
    m_save->hide();
    connect(m_save, &QPushButton::clicked, this, [this] {
        base::askToSave(this,
                        {.title = tr("Save the times of touches"),
                         .filters = {tr("Tables (*.csv)")},
                         .suffix = QStringLiteral("csv"),
                         .name = QStringLiteral("touches.csv")},
                        [this](const QString& path) { saveReceipts(path); });
    });
    m_last->setTextInteractionFlags(Qt::TextSelectableByMouse);
    for (const FeedbackMode mode :
         {FeedbackMode::both, FeedbackMode::stiffness, FeedbackMode::shape, FeedbackMode::off})
        m_mode->addItem(QString(), static_cast<int>(mode));
    auto* top = new QHBoxLayout;
    top->addWidget(m_modeLabel);
    top->addWidget(m_mode, 1);
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addLayout(top);
    layout->addWidget(m_last);
    auto* times = new QHBoxLayout;
    times->addWidget(m_latency, 1);
    times->addWidget(m_save, 0, Qt::AlignTop);
    layout->addLayout(times);
    layout->addWidget(m_table, 1);
    connect(m_mode, &QComboBox::currentIndexChanged, this, [this] {
        m_station.setMode(mode());
        emit changed();
    });
    connect(m_table, &touch::PatternMapTable::mapChanged, this, [this] {
        m_station.setMap(m_table->map());
        emit changed();
    });
    connect(m_table, &touch::PatternMapTable::failed, this, &FeedbackPanel::failed);
    m_station.setMap(m_table->map());
    m_station.setMode(mode());
    offerPatterns();
    connect(&m_station, &BraceletService::felt, this, &FeedbackPanel::showLast);
    retranslate();
    base::onChange(this,
                   [this] {
                       offerPatterns(); // before their new names are used
                       retranslate();
                   },
                   {QEvent::LanguageChange});
}

FeedbackMode FeedbackPanel::mode() const {
    return static_cast<FeedbackMode>(m_mode->currentData().toInt());
}

void FeedbackPanel::setMode(FeedbackMode mode) {
    m_mode->setCurrentIndex(m_mode->findData(static_cast<int>(mode)));
}

const pattern::PatternMap& FeedbackPanel::map() const {
    return m_table->map();
}

void FeedbackPanel::setMap(const pattern::PatternMap& map) {
    m_table->setMap(map);
    m_station.setMap(map);
}

void FeedbackPanel::offerPatterns() {
    std::vector<touch::PatternChoice> choices = m_own;
    for (const pattern::Pattern& pattern : pattern::builtInPatterns())
        choices.push_back({pattern.id, pattern::displayName(pattern),
                           pattern.task == pattern::Task::shape ? tr("shape") : tr("stiffness"),
                           pattern.condition == pattern::Condition::dynamic ? tr("dynamic") : tr("static")});
    const pattern::Pattern& unknown = pattern::unknownStiffness();
    choices.push_back({unknown.id, tr("Unknown stiffness"), tr("stiffness"), tr("dynamic")});
    m_choices = choices;
    m_table->setChoices(std::move(choices));
}

void FeedbackPanel::setOwnPatterns(std::vector<touch::PatternChoice> own) {
    m_own = std::move(own);
    offerPatterns();
}

QString FeedbackPanel::nameOf(const std::string& id) const {
    const auto known = std::ranges::find(m_choices, id, &touch::PatternChoice::id);
    return known != m_choices.end() ? known->name : QString::fromStdString(id);
}

QString FeedbackPanel::lastText() const {
    return m_lastText.isEmpty() || m_station.isFeedbackPlaying()
               ? m_lastText
               : tr("Nothing is played (last: %1)", "what was recognised and its pattern").arg(m_lastText);
}

void FeedbackPanel::forgetLast() {
    m_lastFelt.reset();
    m_lastText.clear();
    m_table->clearRecognised();
    retranslate();
}

void FeedbackPanel::showLast(const TouchReceipt& event) {
    if (event.sent.shape)
        m_table->setRecognisedShape(*event.sent.shape);
    else if (event.sent.unknownStiffness)
        m_table->setUnknownStiffness();
    else
        m_table->setRecognisedStiffness(stiffness::level(*event.sent.material));
    m_lastFelt = event;
    writeLast(event);
    showLatency();
}

void FeedbackPanel::writeLast(const TouchReceipt& event) {
    const QString what = event.sent.shape              ? touch::TouchTexts::shape(*event.sent.shape)
                         : event.sent.unknownStiffness ? touch::PatternMapTable::tr("unknown stiffness")
                                                       : touch::TouchTexts::material(*event.sent.material);
    const QString touch = QString::number(event.sent.touch);
    const QString pattern = nameOf(event.sent.patternId);
    m_lastText = event.sent.missing
                     ? tr("%1: %2 is missing", "what was recognised: id of a pattern").arg(what, pattern)
                 : event.sent.refused
                     ? tr("%1: %2, not played", "what was recognised: id of a pattern").arg(what, pattern)
                 : pattern.isEmpty()
                     ? tr("%1: no pattern", "what was recognised").arg(what)
                     : tr("%1: %2", "what was recognised: id of a pattern").arg(what, pattern);
    if (pattern.isEmpty())
        m_last->setText(tr("Touch %1: %2. There is no pattern for it in the table.").arg(touch, what));
    else if (event.sent.missing)
        m_last->setText(
            tr("Touch %1: %2. Its pattern %3 is missing: nothing was played. Choose another one, or "
               "put it back among your patterns.")
                .arg(touch, what, pattern));
    else if (event.sent.refused)
        m_last->setText(tr("Touch %1: %2. %3 was not played: no bracelet is connected, or a study or a "
                           "calibration is using it.")
                            .arg(touch, what, pattern));
    else if (event.onset_s)
        m_last->setText(tr("Touch %1: %2. %3 was felt %4 later.")
                            .arg(touch, what, pattern, timeText(*event.onset_s, event.clockBound_s())));
    else
        m_last->setText(tr("Touch %1: %2. %3 was sent.").arg(touch, what, pattern));
    m_last->setToolTip(stagesOf(event));
}

QString FeedbackPanel::stagesOf(const TouchReceipt& receipt) const {
    const std::optional<double> bound_s = receipt.clockBound_s();
    QStringList lines{tr("Read: %1")
                          .arg(bound_s ? tr("by the clock of the site, known to ± %1").arg(timeText(*bound_s))
                                       : tr("by the clock of this computer"))};
    if (const std::optional<double> arrived_s = receipt.arrived_s())
        lines << tr("Arrived at the console: %1 later").arg(timeText(*arrived_s));
    lines << tr("Evaluated: %1 later").arg(timeText(receipt.evaluated_s()));
    if (receipt.begin_s)
        lines << tr("First frame to the bracelet: %1 later").arg(timeText(*receipt.begin_s));
    if (receipt.onset_s)
        lines << tr("First frame that is felt: %1 later").arg(timeText(*receipt.onset_s));
    return lines.join(QLatin1Char('\n'));
}

void FeedbackPanel::saveReceipts(const QString& path) {
    const std::deque<TouchReceipt>& known = m_station.receipts();
    base::runInBackground(
        this,
        [path = path.toStdString(), receipts = std::vector<TouchReceipt>(known.begin(), known.end())] {
            return writeReceipts(path, receipts);
        },
        [this](const core::Expected<void>& saved) {
            if (!saved)
                emit failed(QString::fromStdString(core::describe(saved.error())));
        });
}

void FeedbackPanel::showLatency() {
    const std::optional<TouchToSkin::Latency> latency = m_station.touchToSkin();
    m_latency->setVisible(latency.has_value());
    m_save->setVisible(!m_station.receipts().empty());
    if (!latency)
        return;
    QString text = tr("From touch to skin: %1 half of the time, %2 at 99 %.")
                       .arg(timeText(latency->median_s), timeText(latency->p99_s));
    if (latency->bound_s > 0.0)
        text += QLatin1Char(' ') +
                tr("Each is known to ± %1, since two clocks are compared.").arg(timeText(latency->bound_s));
    m_latency->setText(text);
    m_latency->setToolTip(tr("Of the newest touches, with the link between the two sites on the way"));
}

void FeedbackPanel::retranslate() {
    showLatency();
    m_save->setText(tr("Save times…"));
    m_save->setToolTip(tr("Save when each touch was read, arrived from a site, was evaluated, sent and felt, "
                          "as a table (CSV)"));
    m_modeLabel->setText(tr("What to &play:"));
    const QSignalBlocker quiet(m_mode);
    m_mode->setItemText(0, tr("Stiffness and shape"));
    m_mode->setItemText(1, tr("Stiffness"));
    m_mode->setItemText(2, tr("Shape"));
    m_mode->setItemText(3, tr("Nothing"));
    m_mode->setToolTip(tr("What of a touch is played on the bracelet"));
    if (m_lastFelt)
        writeLast(*m_lastFelt);
    else
        m_last->setText(tr("Nothing was recognised yet."));
}

} // namespace teleta::console
