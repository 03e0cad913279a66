// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/session_panel.h"

#include "widgets/base/icons.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/watermark.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QMessageBox>
#include <QPainter>
#include <QSignalBlocker>
#include <QTableWidget>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

QColor toneColour(Tone tone, const QPalette& palette) {
    const base::StatusColours& colours = base::statusColours(palette);
    return tone == Tone::good        ? colours.live
           : tone == Tone::attention ? colours.stale
           : tone == Tone::alarm     ? colours.lost
                                     : palette.color(QPalette::WindowText);
}

/// A state as a coloured strip, visible from afar.
class StateLabel : public QLabel {
public:
    using QLabel::QLabel;
    void setTone(Tone tone) {
        m_tone = tone;
        update();
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QPainter painter(this);
        const QColor strip = toneColour(m_tone, palette());
        const QColor window = palette().color(QPalette::Window);
        if (m_tone != Tone::calm) {
            painter.fillRect(rect(), base::mixed(window, strip, m_tone == Tone::alarm ? 0.3 : 0.14));
            painter.fillRect(QRect(0, 0, base::grid(this, 0.5), height()), strip);
        }
        painter.end();
        QLabel::paintEvent(event);
    }

private:
    Tone m_tone = Tone::calm;
};

enum Column { trialColumn, levelColumn, presentedColumn, answeredColumn, outcomeColumn, timeColumn, columns };

} // namespace

SessionPanel::SessionPanel(QWidget* parent)
    : QWidget(parent)
    , m_state(new StateLabel(this))
    , m_outcomes(new QTableWidget(0, columns, this)) {
    m_title->setTextFormat(Qt::PlainText);
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_mark->setFont(base::bold(font()));
    m_next->setFont(base::sized(m_mark->font(), base::kLargeText));
    m_next->setMinimumHeight(base::em(this, 3.6));
    m_next->setDefault(true);
    m_state->setWordWrap(true);
    m_state->setMargin(base::grid(this));
    m_state->setTextFormat(Qt::PlainText);
    for (QLabel* label : {m_device, m_saved, m_subtitle, m_noiseText}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setFont(base::sized(font(), base::kSmallText));
    }
    m_checkLines->setContentsMargins(0, 0, 0, 0);
    m_checkLines->setSpacing(base::grid(this, 0.5));
    m_outcomes->verticalHeader()->hide();
    m_outcomes->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_outcomes->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_outcomes->setAlternatingRowColors(true);
    m_outcomes->setWordWrap(false);
    m_outcomes->verticalHeader()->setDefaultSectionSize(base::em(this, 1.6));
    m_outcomes->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_outcomes->horizontalHeader()->setResizeContentsPrecision(0); // what is in sight
    m_outcomes->horizontalHeader()->setStretchLastSection(true);
    m_outcomes->setFocusPolicy(Qt::TabFocus);
    m_outcomes->hideColumn(levelColumn);

    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_mark);
    auto* noise = new QHBoxLayout(m_noiseRow);
    noise->setContentsMargins(0, 0, 0, 0);
    noise->addWidget(m_noisePlay);
    noise->addWidget(m_noise);
    noise->addWidget(m_noiseText, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_window);
    buttons->addStretch(1);
    base::addWidgets(buttons, {m_skip, m_pause, m_abort});
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(this));
    layout->addLayout(head);
    base::addWidgets(layout, {m_subtitle, m_next, m_state, m_checks, m_noiseRow, m_progress, m_device});
    layout->addWidget(m_outcomes, 1);
    layout->addWidget(m_saved);
    layout->addWidget(m_note);
    layout->addLayout(buttons);

    connect(m_next, &QPushButton::clicked, this, &SessionPanel::nextRequested);
    connect(m_pause, &QPushButton::clicked, this, &SessionPanel::pauseRequested);
    connect(m_skip, &QPushButton::clicked, this, &SessionPanel::askForSkip);
    connect(m_abort, &QPushButton::clicked, this, &SessionPanel::askForAbort);
    connect(m_window, &QPushButton::clicked, this, &SessionPanel::participantWindowRequested);
    connect(m_noise, &QCheckBox::toggled, this, &SessionPanel::noiseConfirmed);
    connect(m_noisePlay, &QPushButton::clicked, this,
            [this] { emit noisePlayRequested(!m_scene.noisePlaying); });
    connect(m_note, &QLineEdit::returnPressed, this, [this] {
        const QString text = m_note->text().trimmed();
        if (text.isEmpty())
            return;
        m_note->clear();
        emit noteWritten(text);
    });
    base::keepTranslated(this, &SessionPanel::retranslate);
    base::onChange(this,
                   [this] {
                       showChecks();
                       showOutcomes();
                       refresh();
                   },
                   {QEvent::PaletteChange});
}

void SessionPanel::setScene(const SessionScene& scene) {
    if (scene == m_scene)
        return;
    const bool newChecks = scene.checks != m_scene.checks;
    const bool newOutcomes = scene.outcomes != m_scene.outcomes;
    if (scene.questionnaire != m_scene.questionnaire) {
        // The question was about one that is over.
        for (auto* box : findChildren<QMessageBox*>(QStringLiteral("confirmSkip")))
            box->close();
    }
    const std::vector<OutcomeLine> before = std::exchange(m_scene, scene).outcomes;
    if (newChecks)
        showChecks();
    if (newOutcomes) {
        m_outcomes->setColumnHidden(levelColumn, std::ranges::all_of(m_scene.outcomes, [](const auto& line) {
                                        return line.level.isEmpty();
                                    }));
        showNewOutcomes(before);
    }
    refresh();
}

void SessionPanel::takeKeyboard() {
    m_keyboardDue = true;
    refresh();
}

void SessionPanel::restoreNote(const QString& text) {
    m_note->setText(m_note->text().isEmpty() ? text : text + QLatin1Char(' ') + m_note->text());
}

void SessionPanel::refresh() {
    m_title->setText(m_scene.title);
    m_subtitle->setText(m_scene.subtitle);
    base::setTextColour(m_subtitle, palette().color(QPalette::PlaceholderText));
    m_mark->setText(modeMark(m_scene.mode));
    base::setTextColour(m_mark, modeColour(m_scene.mode, palette()));
    if (m_next->text() != m_scene.next) {
        m_next->setText(m_scene.next);
        m_next->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return)); // a new text takes it away
    }
    m_next->setEnabled(m_scene.nextEnabled);
    if (m_keyboardDue && m_scene.nextEnabled) {
        m_keyboardDue = false;
        m_next->setFocus(Qt::OtherFocusReason);
    }
    m_state->setText(m_scene.state);
    m_state->setVisible(!m_scene.state.isEmpty());
    static_cast<StateLabel*>(m_state)->setTone(m_scene.tone);
    m_checks->setVisible(!m_scene.checks.empty());
    m_noiseRow->setVisible(m_scene.needsNoise);
    const QSignalBlocker quiet(m_noise);
    m_noise->setChecked(m_scene.noiseConfirmed);
    m_noisePlay->setText(m_scene.noisePlaying ? tr("Stop the noise") : tr("Play the noise"));
    m_noisePlay->setIcon(base::themeIcon(m_scene.noisePlaying ? base::Icon::pause : base::Icon::play));
    m_noiseText->setText(m_scene.noiseText);
    m_progress->setVisible(m_scene.total > 0);
    m_progress->setRange(0, static_cast<int>(m_scene.total));
    m_progress->setValue(static_cast<int>(m_scene.done));
    m_progress->setFormat(QStringLiteral("%1  %v / %m").arg(m_scene.phase));
    m_device->setText(m_scene.device);
    base::setTextColour(m_device, toneColour(m_scene.deviceTone, palette()));
    m_saved->setText(m_scene.saved);
    m_saved->setVisible(!m_scene.saved.isEmpty());
    m_pause->setEnabled(m_scene.canPause);
    m_abort->setEnabled(m_scene.canAbort);
    m_note->setEnabled(m_scene.canNote);
    m_skip->setVisible(m_scene.canSkip);
}

void SessionPanel::showChecks() {
    while (QLayoutItem* item = m_checkLines->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const CheckLine& check : m_scene.checks) {
        auto* label = new QLabel(m_checks);
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        // Not necessary, but something is left to do.
        const bool isAdvice = check.passed && !check.remedy.isEmpty();
        const QString sign = isAdvice       ? QStringLiteral("!")
                             : check.passed ? QStringLiteral("\u2713")
                                            : QStringLiteral("\u2717");
        const QString line = QStringLiteral("%1  %2: %3").arg(sign, check.name, check.finding);
        label->setText(check.remedy.isEmpty() ? line
                                              : line + QStringLiteral("\n     \u2192 ") + check.remedy);
        base::setTextColour(label, toneColour(isAdvice       ? Tone::attention
                                              : check.passed ? Tone::good
                                                             : Tone::alarm,
                                              palette()));
        m_checkLines->addWidget(label);
    }
}

void SessionPanel::showOutcomes() {
    m_outcomes->setRowCount(static_cast<int>(m_scene.outcomes.size()));
    for (int row = 0; row < m_outcomes->rowCount(); ++row)
        showOutcome(row);
}

/// After a trial only the newest line differs.
void SessionPanel::showNewOutcomes(const std::vector<OutcomeLine>& before) {
    const std::vector<OutcomeLine>& now = m_scene.outcomes;
    const bool oneMore = !now.empty() && !before.empty() && now.size() <= before.size() + 1 &&
                         std::equal(now.begin() + 1, now.end(), before.begin());
    if (!oneMore) {
        showOutcomes();
        return;
    }
    m_outcomes->insertRow(0);
    showOutcome(0);
    m_outcomes->setRowCount(static_cast<int>(now.size()));
}

void SessionPanel::showOutcome(int row) {
    const OutcomeLine& line = m_scene.outcomes[static_cast<std::size_t>(row)];
    const QString time = line.responseTime_s
                             ? base::withUnit(base::threeDigits(line.responseTime_s), QStringLiteral("s"))
                             : QString();
    const QStringList texts{line.trial, line.level, line.presented, line.answered, line.outcome, time};
    for (int column = 0; column < columns; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setTextAlignment(Qt::AlignCenter);
        if (column == outcomeColumn)
            item->setForeground(toneColour(line.tone, palette()));
        m_outcomes->setItem(row, column, item);
    }
}

void SessionPanel::askForAbort() {
    auto* box = new QMessageBox(
        QMessageBox::Warning, tr("Abort the session?"),
        tr("The session ends here. All answers are saved, and it can be resumed later where it stopped."),
        QMessageBox::NoButton, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("confirmAbort"));
    QPushButton* abort = box->addButton(tr("&Abort the session"), QMessageBox::DestructiveRole);
    box->setDefaultButton(box->addButton(tr("&Go on"), QMessageBox::RejectRole));
    connect(abort, &QPushButton::clicked, this, &SessionPanel::abortRequested);
    box->open();
}

void SessionPanel::askForSkip() {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Skip the questionnaire?"),
                                tr("What is filled in is lost, and a note says that it was skipped."),
                                QMessageBox::NoButton, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("confirmSkip"));
    box->setInformativeText(m_scene.skipConsequence);
    QPushButton* skip = box->addButton(tr("&Skip it"), QMessageBox::DestructiveRole);
    box->setDefaultButton(box->addButton(tr("&Continue with it"), QMessageBox::RejectRole));
    connect(skip, &QPushButton::clicked, this,
            [this, questionnaire = m_scene.questionnaire] { emit skipRequested(questionnaire); });
    box->open();
}

void SessionPanel::retranslate() {
    m_next->setAccessibleName(tr("Next step"));
    m_next->setToolTip(tr("What to do next (Ctrl+Return)"));
    m_checks->setAccessibleName(tr("Checks before the run"));
    m_noise->setText(tr("Noise &confirmed"));
    m_noise->setToolTip(tr("The participant hears the masking noise at the level of the protocol"));
    m_progress->setAccessibleName(tr("Progress"));
    m_outcomes->setAccessibleName(tr("Last trials"));
    m_outcomes->setHorizontalHeaderLabels(
        {tr("Trial"), tr("Level"), tr("Presented"), tr("Answered"), tr("Outcome"), tr("Time")});
    m_outcomes->horizontalHeaderItem(timeColumn)->setToolTip(tr("Response time"));
    m_note->setPlaceholderText(tr("A note on this session; Return saves it"));
    m_note->setAccessibleName(tr("Note"));
    m_window->setText(tr("Participant's &window"));
    m_window->setToolTip(tr("Shows the participant's window, on the second screen if there is one"));
    m_skip->setText(tr("S&kip the questionnaire\u2026"));
    m_skip->setToolTip(tr("Continues without the participant's answers"));
    m_pause->setText(tr("&Pause"));
    m_pause->setToolTip(tr("Pauses after the current trial"));
    m_abort->setText(tr("Ab&ort\u2026"));
    refresh();
}

} // namespace teleta::study
