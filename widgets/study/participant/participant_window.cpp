// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/participant_window.h"

#include "widgets/base/theme.h"
#include "widgets/study/participant/answer_button.h"
#include "widgets/study/participant/answer_keys.h"
#include "widgets/study/watermark.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPointingDevice>
#include <QTouchEvent>
#include <QVBoxLayout>

#include <utility>

namespace teleta::study {

using State = ParticipantScene::State;

namespace {

QString pointerDevice(const QPointerEvent& event) {
    return event.pointingDevice()->type() == QInputDevice::DeviceType::TouchScreen ? QStringLiteral("touch")
                                                                                   : QStringLiteral("mouse");
}

} // namespace

ParticipantWindow::ParticipantWindow(Clock clock, QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_clock(std::move(clock)) {
    setObjectName(QStringLiteral("participantWindow"));
    setFocusPolicy(Qt::StrongFocus);
    for (QLabel* label : {m_title, m_instruction}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this, 3);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(this, 2));
    layout->addWidget(m_title);
    layout->addWidget(m_instruction);
    layout->addLayout(m_grid, 1);
    layout->addWidget(m_questionnaire, 1000);
    m_questionnaire->hide();
    connect(m_questionnaire, &QuestionnaireForm::submitted, this, &ParticipantWindow::questionnaireAnswered);
    resize(base::em(this, 60), base::em(this, 44));
    refresh();
}

void ParticipantWindow::setChoices(std::vector<AnswerChoice> choices) {
    m_choices = std::move(choices);
    if (m_choices.size() > kMostAnswers)
        m_choices.resize(kMostAnswers);
    arrange();
    refresh();
}

void ParticipantWindow::arrange() {
    for (AnswerButton* button : m_buttons)
        delete button;
    m_buttons.clear();
    // Two to four per row, as even as possible.
    const std::size_t count = m_choices.size();
    const std::size_t columns = count <= 3 ? count : count == 4 ? 2 : count <= 6 || count == 9 ? 3 : 4;
    for (std::size_t i = 0; i < count; ++i) {
        auto* button = new AnswerButton(m_choices[i], i + 1, this);
        m_grid->addWidget(button, static_cast<int>(i / columns), static_cast<int>(i % columns));
        m_buttons.push_back(button);
        button->show();
    }
    m_grid->setSpacing(base::grid(this, 2));
}

void ParticipantWindow::setQuestionnaire(const Questionnaire& questionnaire,
                                         const std::vector<ItemAnswer>& answers) {
    m_questionnaireTitle = QString::fromStdString(questionnaire.title);
    m_questionnaire->setQuestionnaire(questionnaire, answers);
    refresh();
    if (m_scene.state == State::questionnaire)
        m_questionnaire->takeKeyboard();
}

void ParticipantWindow::setScene(const ParticipantScene& scene) {
    if (scene == m_scene)
        return;
    const bool wasQuestionnaire = m_scene.state == State::questionnaire;
    const bool wasLocked = m_scene.questionnaireLocked;
    const bool newGround = (scene.state == State::stopped) != (m_scene.state == State::stopped);
    m_scene = scene;
    refresh();
    // The parts of the window detect changes themselves.
    if (newGround)
        update();
    if (m_scene.state == State::questionnaire && !wasQuestionnaire) {
        // Key releases would go to the questionnaire.
        releaseAll();
        m_questionnaire->takeKeyboard();
    } else if (m_scene.state == State::questionnaire && wasLocked && !m_scene.questionnaireLocked) {
        // A locked form has lost the keyboard focus.
        m_questionnaire->takeKeyboard();
    } else if (wasQuestionnaire && m_scene.state != State::questionnaire) {
        setFocus();
    }
}

QString ParticipantWindow::instruction() const {
    switch (m_scene.state) {
    case State::waiting:
        return tr("Please wait for the experimenter.");
    case State::ready:
        return m_scene.answered || m_scene.trial > 1 ? tr("Press Space for the next trial.")
                                                     : tr("Press Space for the first trial.");
    case State::starting:
        return tr("Wait \u2026");
    case State::stimulus:
    case State::answering:
        if (m_scene.interval > 0)
            return QString::number(m_scene.interval);
        if (!m_scene.answersOpen)
            return tr("Feel \u2026");
        if (!m_scene.question.isEmpty())
            return m_scene.canReplay ? tr("%1 Press R to feel it again.", "a question").arg(m_scene.question)
                                     : m_scene.question;
        return m_scene.canReplay ? tr("Which pattern do you feel? Press R to feel it again.")
                                 : tr("Which pattern do you feel?");
    case State::feedback:
        if (!m_scene.question.isEmpty())
            return !m_scene.answered ? tr("There was no answer in time. The marked answer was the right one. "
                                          "Press Space to "
                                          "continue.")
                   : m_scene.answered == m_scene.presented
                       ? tr("Right. Press Space to continue.")
                       : tr("The answer marked with \u2713 was the right one. Press Space to continue.");
        if (!m_scene.answered)
            return tr("There was no answer in time. The marked pattern was the right one. Press Space to "
                      "continue.");
        return m_scene.answered == m_scene.presented
                   ? tr("Right. Press Space to continue.")
                   : tr("That was another one: the pattern marked with \u2713 was the right one. Press Space "
                        "to continue.");
    case State::resting:
        return m_scene.restLeft_s > 0 ? tr("Take a break. You can continue in %1 s.").arg(m_scene.restLeft_s)
                                      : tr("Take a break. Press Space when you would like to continue.");
    case State::paused:
        return tr("Pause. Please wait for the experimenter.");
    case State::stopped:
        return tr("Stopped. The bracelet is off. Please wait for the experimenter.");
    case State::finished:
        return tr("This part is finished. Thank you!");
    case State::ended:
        return tr("The session has ended. Please wait for the experimenter.");
    case State::questionnaire:
        return m_questionnaireTitle;
    }
    return {};
}

void ParticipantWindow::refresh() {
    setWindowTitle(tr("Participant"));
    m_title->setFont(base::sized(font(), base::kNormalText));
    QFont large = base::sized(font(), base::kHugeText);
    large.setBold(m_scene.state == State::stopped);
    m_instruction->setFont(large);
    // Two lines are reserved, so that a long instruction does not move the answers.
    m_instruction->setMinimumHeight(3 * QFontMetrics(large).lineSpacing());
    const QString phase = m_scene.phase == Phase::practice ? tr("Practice") : tr("Test");
    QString title = m_scene.trials == 0 ? m_scene.title
                                        : tr("%1 \u2014 %2, trial %3 of %4", "task, phase, numbers")
                                              .arg(m_scene.title, phase)
                                              .arg(m_scene.trial)
                                              .arg(m_scene.trials);
    if (const QString mark = modeMark(m_scene.mode); !mark.isEmpty())
        title = mark + QStringLiteral(" \u00b7 ") + title;
    const bool asks = m_scene.state == State::questionnaire;
    m_title->setText(title);
    m_instruction->setText(instruction());
    m_questionnaire->setVisible(asks);
    // A questionnaire's buttons handle touches themselves.
    setAttribute(Qt::WA_AcceptTouchEvents, !asks);
    m_questionnaire->setLocked(m_scene.questionnaireLocked);
    m_questionnaire->setProblem(m_scene.questionnaireProblem);
    setAccessibleDescription(m_instruction->text());
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const bool wasPresented = m_scene.presented == i;
        const bool wasAnswered = m_scene.answered == i;
        const bool told = m_scene.state == State::feedback;
        const bool isLit = m_scene.interval > 0 && m_choices[i].letter == QString::number(m_scene.interval);
        m_buttons[i]->setVisible(!asks);
        m_buttons[i]->setDiagramShown(m_scene.diagrams);
        m_buttons[i]->setOpen(m_scene.answersOpen);
        m_buttons[i]->setLook(told && wasPresented                           ? AnswerButton::Look::right
                              : told && wasAnswered                          ? AnswerButton::Look::wrong
                              : isLit                                        ? AnswerButton::Look::lit
                              : wasAnswered && m_scene.state == State::ready ? AnswerButton::Look::chosen
                                                                             : AnswerButton::Look::plain);
    }
}

void ParticipantWindow::paintNow() {
    layout()->activate();
    QEvent update(QEvent::UpdateRequest);
    QCoreApplication::sendEvent(this, &update);
}

void ParticipantWindow::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (m_scene.state == State::stopped) {
        const QColor stop = base::statusColours(palette()).stop;
        painter.setPen(QPen(stop, base::grid(this, 1.5)));
        painter.setBrush(base::mixed(palette().color(QPalette::Window), stop, 0.15));
        painter.drawRect(rect());
    }
}

bool ParticipantWindow::event(QEvent* event) {
    if (m_scene.state == State::questionnaire)
        return QWidget::event(event);
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate: {
        auto* touch = static_cast<QTouchEvent*>(event);
        const std::int64_t time_ns = timeOf(*touch);
        for (const QEventPoint& point : touch->points()) {
            if (point.state() == QEventPoint::Pressed)
                pressAt(point.position(), QStringLiteral("touch"), time_ns);
        }
        // Accepted: otherwise the touch would be repeated as a mouse event.
        event->accept();
        return true;
    }
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        releasePointer();
        event->accept();
        return true;
    default:
        return QWidget::event(event);
    }
}

/// Every input event shows the delay of handling.
std::int64_t ParticipantWindow::timeOf(const QInputEvent& event) {
    return m_eventClock.time_ns(event.timestamp(), m_clock());
}

void ParticipantWindow::keyPressEvent(QKeyEvent* event) {
    if (m_scene.state == State::questionnaire) {
        QWidget::keyPressEvent(event);
        return;
    }
    const std::int64_t time_ns = timeOf(*event);
    std::optional<PhysicalKey> key = physicalKey(*event);
    if (key && key->kind == PhysicalKey::Kind::letter && !answerOf(*key))
        key.reset();
    if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (!key) {
        if (event->key() == Qt::Key_R && !event->isAutoRepeat() && m_scene.canReplay)
            emit replayRequested(time_ns);
        else
            QWidget::keyPressEvent(event);
        return;
    }
    if (key->kind == PhysicalKey::Kind::space) {
        // Auto-repeat would run through the trials.
        if (!event->isAutoRepeat())
            emit nextRequested(time_ns);
        return;
    }
    KeyPress press;
    press.response = answerOf(*key);
    press.device = key->device().toStdString();
    press.key = key->code().toStdString();
    press.time_ns = time_ns;
    press.autoRepeat = event->isAutoRepeat();
    if (!press.autoRepeat)
        m_down.emplace(key->device(), key->code());
    emit pressed(press);
}

std::optional<std::size_t> ParticipantWindow::answerOf(const PhysicalKey& key) const {
    if (key.number >= 1 && key.number <= m_choices.size())
        return key.number - 1;
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        if (key.letter != 0 && m_choices[i].key == QLatin1Char(key.letter))
            return i;
    }
    return std::nullopt;
}

void ParticipantWindow::keyReleaseEvent(QKeyEvent* event) {
    (void)timeOf(*event);
    const std::optional<PhysicalKey> key = physicalKey(*event);
    if (!key || event->isAutoRepeat()) {
        QWidget::keyReleaseEvent(event);
        return;
    }
    if (m_down.erase({key->device(), key->code()}) > 0)
        emit released(key->device(), key->code());
}

void ParticipantWindow::mousePressEvent(QMouseEvent* event) {
    const std::int64_t time_ns = timeOf(*event);
    if (event->button() == Qt::LeftButton)
        pressAt(event->position(), pointerDevice(*event), time_ns);
}

void ParticipantWindow::mouseReleaseEvent(QMouseEvent* event) {
    (void)timeOf(*event);
    if (event->button() == Qt::LeftButton)
        releasePointer();
}

void ParticipantWindow::pressAt(const QPointF& at, const QString& device, std::int64_t time_ns) {
    if (m_scene.state == State::questionnaire)
        return;
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        if (!m_buttons[i]->geometry().contains(at.toPoint()))
            continue;
        const QString button = QStringLiteral("button %1").arg(m_choices[i].letter);
        m_down.emplace(device, button);
        KeyPress press;
        press.response = i;
        press.device = device.toStdString();
        press.key = button.toStdString();
        press.time_ns = time_ns;
        emit pressed(press);
        return;
    }
    // A press outside the buttons asks for the next trial, so that no keyboard is needed.
    if (m_scene.state == State::ready || m_scene.state == State::feedback || m_scene.state == State::resting)
        emit nextRequested(time_ns);
}

void ParticipantWindow::releasePointer() {
    const auto down = m_down;
    for (const auto& [device, key] : down) {
        if (device == QLatin1String("mouse") || device == QLatin1String("touch")) {
            m_down.erase({device, key});
            emit released(device, key);
        }
    }
}

/// Releases of keys that are still down will go to another window.
void ParticipantWindow::releaseAll() {
    const auto down = std::exchange(m_down, {});
    for (const auto& [device, key] : down)
        emit released(device, key);
}

void ParticipantWindow::closeEvent(QCloseEvent* event) {
    releaseAll();
    emit left();
    QWidget::closeEvent(event);
}

void ParticipantWindow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
        update();
        refresh();
    }
    if (event->type() == QEvent::ActivationChange && !isActiveWindow())
        releaseAll();
}

} // namespace teleta::study
