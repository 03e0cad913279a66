// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/page/bracelet_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/results/bracelet_content.h"
#include "widgets/study/results/result_table.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

namespace teleta::study {

BraceletView::BraceletView(QWidget* parent)
    : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    auto* column = new QVBoxLayout(m_content);
    const int margin = base::grid(this, 2);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(base::grid(this, 1.5));
    m_onsets = addSection("onsetTable");
    m_steps = addSection("stepTable");
    m_strength = addSection("strengthTable");
    m_line = new QWidget(m_content);
    m_whoLabel = new QLabel(m_line);
    m_who = base::named<QComboBox>("strengthOf", m_line);
    m_who->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_whoLabel->setBuddy(m_who);
    m_use = base::named<QPushButton>("useForBracelet", m_line);
    auto* line = new QHBoxLayout(m_line);
    line->setContentsMargins(0, 0, 0, 0);
    base::addWidgets(line, {m_whoLabel, m_who, m_use});
    line->addStretch(1);
    m_note = base::named<QLabel>("strengthNote", m_content);
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    base::addWidgets(column, {m_line, m_note});
    column->addStretch(1);
    setWidget(m_content);
    connect(m_who, &QComboBox::currentIndexChanged, this, &BraceletView::showStrength);
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (m_balanced)
            emit useRequested(*m_balanced, m_who->currentText());
    });
    base::keepTranslated(this, &BraceletView::retranslate);
}

BraceletView::Section BraceletView::addSection(const char* name) {
    Section section{new QLabel(m_content), new ResultTable(QString::fromLatin1(name), m_content)};
    section.title->setFont(base::bold(base::sized(section.title->font(), base::kTitleText)));
    section.table->setObjectName(QLatin1String(name));
    base::addWidgets(static_cast<QVBoxLayout*>(m_content->layout()), {section.title, section.table});
    connect(&section.table->exporter(), &base::FigureExport::failed, this, &BraceletView::figureFailed);
    return section;
}

void BraceletView::setContent(std::shared_ptr<const LevelResults> results, const QString& task,
                              const ConditionNames& names, const std::optional<BraceletMotors>& motors,
                              Mode mode) {
    m_results = std::move(results);
    m_task = task;
    m_motors = motors;
    m_mode = mode;
    const auto fill = [](const Section& section, const TableContent& content) {
        section.table->setRows(content.header, content.tips, content.rows);
        section.title->setVisible(!content.rows.empty());
        section.table->setVisible(!content.rows.empty());
    };
    fill(m_onsets, m_results ? BraceletContent::onsets(*m_results, task, names) : TableContent());
    fill(m_steps, m_results ? BraceletContent::steps(*m_results, task) : TableContent());
    fillPeople();
    showStrength();
}

/// Keeps who is chosen.
void BraceletView::fillPeople() {
    const QSignalBlocker quiet(m_who);
    const QString chosen = m_who->currentData().toString();
    m_who->clear();
    m_who->addItem(tr("All participants, mean"), QString());
    std::set<QString> people;
    if (m_results) {
        for (const ThresholdLine& line : m_results->thresholds.lines) {
            if (QString::fromStdString(line.task) == m_task)
                people.insert(QString::fromStdString(line.participant));
        }
    }
    for (const QString& person : people)
        m_who->addItem(person, person);
    m_who->setCurrentIndex(std::max(0, m_who->findData(chosen)));
}

void BraceletView::showStrength() {
    const QString who = m_who->currentData().toString();
    const std::optional<EqualStrength> equal =
        m_results ? BraceletContent::equal(*m_results, m_task, who) : std::nullopt;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_strength.title, m_strength.table, m_line, m_note})
        widget->setVisible(equal.has_value());
    m_balanced.reset();
    if (!equal)
        return;
    const FeltTask& felt = *m_results->feltTask(m_task);
    const pattern::MotorProfiles* motors = m_motors ? &m_motors->profiles : nullptr;
    QStringList notes;
    if (motors == nullptr) {
        notes << tr("Connect the bracelet with which the study was run: the balance needs its motors.");
    } else if (const auto balanced = balancedMotors(*equal, felt.strongest, *motors)) {
        m_balanced = *balanced;
        notes
            << tr("The balance takes the motors of %1 as they are now. They must be the ones that the study "
                  "was run with.")
                   .arg(m_motors->name);
        if (const auto conflicts = BraceletContent::conflicts(*m_results, m_task, who, *motors);
            !conflicts.empty())
            notes << BraceletContent::conflictText(conflicts);
    } else {
        notes << tr("There is no balance: %1.").arg(QString::fromStdString(balanced.error().message));
    }
    const bool nobodyFeltIt = m_mode == Mode::simulated && m_motors && !m_motors->simulated;
    if (nobodyFeltIt)
        notes << tr("The participants are simulated: nobody felt this, so it cannot be used for a real "
                    "bracelet.");
    const TableContent table = BraceletContent::strength(*equal, felt.strongest, motors, m_balanced);
    m_strength.table->setRows(table.header, table.tips, table.rows);
    m_note->setText(notes.join(QLatin1Char('\n')));
    m_use->setEnabled(m_balanced.has_value() && !nobodyFeltIt);
}

void BraceletView::retranslate() {
    const auto name = [](const Section& section, const QString& title) {
        section.title->setText(title);
        section.table->setAccessibleName(title);
    };
    name(m_onsets, tr("Best time from burst to burst"));
    name(m_steps, tr("Intensities that can be told apart"));
    name(m_strength, tr("Equally strong tactors"));
    m_whoLabel->setText(tr("As felt b&y"));
    m_use->setText(tr("&Use for this bracelet\u2026"));
    m_use->setToolTip(tr("Sets the full drives of the connected bracelet, after a question"));
    if (m_who->count() > 0)
        m_who->setItemText(0, tr("All participants, mean"));
}

} // namespace teleta::study
