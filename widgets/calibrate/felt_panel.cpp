// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/felt_panel.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <utility>

namespace teleta::calibrate {

FeltPanel::FeltPanel(QWidget* parent)
    : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_question->setFont(base::sized(font(), base::kLargeText));
    for (QLabel* label : {m_title, m_question, m_trouble})
        label->setWordWrap(true);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    auto* answers = new QHBoxLayout;
    for (QPushButton* button : {m_no, m_yes}) {
        button->setMinimumHeight(base::em(this, 3.5));
        button->setFont(base::sized(font(), base::kLargeText));
        answers->addWidget(button, 1);
    }
    m_play->setMinimumHeight(base::em(this, 2.2));
    auto* below = new QHBoxLayout;
    below->addWidget(m_undo);
    below->addStretch(1);
    below->addWidget(m_cancel);
    for (QPushButton* button : {m_play, m_yes, m_no, m_undo, m_cancel}) {
        // The panel handles the keys.
        button->setFocusPolicy(Qt::NoFocus);
        button->setAutoDefault(false);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(base::grid(this));
    base::addWidgets(layout, {m_title, m_progress, m_play, m_question});
    layout->addLayout(answers);
    layout->addWidget(m_trouble);
    layout->addStretch(1);
    layout->addLayout(below);
    connect(m_play, &QPushButton::clicked, this, &FeltPanel::present);
    connect(m_yes, &QPushButton::clicked, this, [this] { answer(true); });
    connect(m_no, &QPushButton::clicked, this, [this] { answer(false); });
    connect(m_undo, &QPushButton::clicked, this, &FeltPanel::undoAnswer);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        end();
        emit cancelled();
    });
    base::keepTranslated(this, &FeltPanel::retranslate);
}

void FeltPanel::begin(FeltTask task) {
    m_task = std::move(task);
    m_presented = false;
    refresh();
    setFocus();
}

void FeltPanel::setReady(bool ready) {
    if (std::exchange(m_ready, ready) == ready)
        return;
    // A burst cut off by STOP or by the loss of the bracelet does not count as presented.
    if (!ready)
        m_presented = false;
    refresh();
}

void FeltPanel::present() {
    if (!m_task || !m_ready || m_task->done())
        return;
    m_presented = true;
    emit playRequested(m_task->presentation());
    refresh();
}

void FeltPanel::answer(bool yes) {
    if (!m_task || !m_ready || !m_presented || m_task->done())
        return;
    m_task->answer(yes);
    m_presented = false;
    if (m_task->done())
        conclude();
    else
        present();
}

void FeltPanel::undoAnswer() {
    if (!m_task || !m_task->undo())
        return;
    m_presented = false;
    refresh();
}

void FeltPanel::conclude() {
    const auto result = m_task->result();
    if (!result) {
        refresh();
        m_trouble->setText(QString::fromStdString(core::describe(result.error())));
        return;
    }
    QString verdict = tr("The motors were balanced by feel.");
    if (const auto threshold = m_task->threshold(); m_task->kind() == FeltTask::Kind::start && threshold)
        verdict = tr("Motor %1 starts at %2 % of the full drive (95 %: %3 to %4 %).")
                      .arg(m_task->motor() + 1)
                      .arg(base::fixedDigits(100.0 * threshold->drive, 1),
                           base::fixedDigits(100.0 * threshold->lower, 1),
                           base::fixedDigits(100.0 * threshold->upper, 1));
    end();
    emit finished(*result, verdict);
}

void FeltPanel::refresh() {
    if (!m_task)
        return;
    const bool start = m_task->kind() == FeltTask::Kind::start;
    const bool done = m_task->done();
    m_title->setText(start ? tr("Start of motor %1").arg(m_task->motor() + 1)
                           : tr("Strength of motor %1, compared with motor 1").arg(m_task->motor() + 1));
    m_progress->setValue(static_cast<int>(100.0 * m_task->progress()));
    m_progress->setToolTip(tr("%1 answers so far").arg(m_task->answers()));
    m_question->setText(done           ? tr("The answers contradict each other.")
                        : !m_presented ? tr("Play the next burst.")
                        : start        ? tr("Did you feel it?")
                                       : tr("Was the second burst stronger?"));
    m_trouble->setText(!m_ready
                           ? tr("The bracelet cannot play now: it is not connected, STOP is engaged, or a "
                                "study uses it.")
                       : start ? tr("Now and then nothing is played. Answer yes only when you are sure.")
                               : tr("Guess when you are not sure."));
    m_play->setEnabled(m_ready && !done);
    for (QPushButton* button : {m_yes, m_no})
        button->setEnabled(m_ready && m_presented && !done);
    m_undo->setEnabled(m_task->answers() > 0);
}

void FeltPanel::keyPressEvent(QKeyEvent* event) {
    if (event->isAutoRepeat() || (event->modifiers() & ~Qt::KeypadModifier)) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Space:
        present();
        break;
    case Qt::Key_Y:
    case Qt::Key_Right:
        answer(true);
        break;
    case Qt::Key_N:
    case Qt::Key_Left:
        answer(false);
        break;
    case Qt::Key_Backspace:
        undoAnswer();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

void FeltPanel::retranslate() {
    setAccessibleName(tr("Questions about what is felt"));
    m_play->setText(tr("Play (Space)"));
    m_play->setToolTip(tr("Play the burst, as often as you like"));
    m_yes->setText(tr("Yes (Y)"));
    m_no->setText(tr("No (N)"));
    m_undo->setText(tr("Take back the last answer (Backspace)"));
    m_cancel->setText(tr("Give up"));
    m_cancel->setToolTip(tr("Leave the motors as they were"));
    refresh();
}

} // namespace teleta::calibrate
