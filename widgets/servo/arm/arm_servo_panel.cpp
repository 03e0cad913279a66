// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/arm/arm_servo_panel.h"

#include "widgets/base/controls/hold_button.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"
#include "widgets/servo/arm/arm_servo_texts.h"
#include "widgets/servo/servo_texts.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <utility>

namespace teleta::arm_servo {

namespace {

constexpr double kTouchTarget_em = 2.2;

} // namespace

ArmServoPanel::ArmServoPanel(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_task(new QComboBox(this))
    , m_force(new QDoubleSpinBox(this))
    , m_form(new QFormLayout)
    , m_button(new base::HoldButton(this))
    , m_stage(new QLabel(this))
    , m_what(new QLabel(this))
    , m_ending(new QLabel(this)) {
    setFocusPolicy(Qt::StrongFocus);
    m_title->setFont(base::bold(base::sized(font(), base::kTitleText)));
    m_task->setObjectName(QStringLiteral("armTask"));
    for (std::size_t i = 0; i < kArmTasks.size(); ++i)
        m_task->addItem({});
    m_force->setObjectName(QStringLiteral("armForce"));
    m_force->setRange(kLeastForce_N, kHighestForce_N);
    m_force->setDecimals(1);
    m_force->setSingleStep(0.5);
    m_force->setValue(usualForce_N(ArmTask::point));
    m_button->setObjectName(QStringLiteral("armServoHold"));
    m_button->setMinimumHeight(base::em(this, kTouchTarget_em));
    m_stage->setObjectName(QStringLiteral("armServoStage"));
    m_ending->setObjectName(QStringLiteral("armServoEnding"));
    for (QLabel* label : {m_stage, m_what, m_ending})
        label->setWordWrap(true);
    for (QWidget* field : {static_cast<QWidget*>(m_task), static_cast<QWidget*>(m_force)}) {
        auto* name = new QLabel(this);
        name->setBuddy(field);
        m_form->addRow(name, field);
    }
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
    layout->setSpacing(margin / 2);
    layout->addWidget(m_title);
    layout->addLayout(m_form);
    layout->addWidget(m_button); // above what grows: it must not move away from the mouse that holds it
    layout->addWidget(m_ending); // before what comes next
    layout->addWidget(m_stage);
    layout->addWidget(m_what);
    layout->addStretch(1);

    connect(m_button, &base::HoldButton::heldChanged, this, [this](bool held, Qt::KeyboardModifiers) {
        if (held)
            setFocus(Qt::MouseFocusReason);
        take();
    });
    connect(m_task, &QComboBox::currentIndexChanged, this, [this] {
        letGo();
        const QSignalBlocker blocker(m_force);
        m_force->setValue(usualForce_N(task()));
        emit taskChanged(task(), force_N());
    });
    connect(m_force, &QDoubleSpinBox::valueChanged, this, [this] {
        letGo();
        emit taskChanged(task(), force_N());
    });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now != this)
            letGo();
    });
    retranslate();
}

ArmServoPanel::~ArmServoPanel() {
    // The parts that are destroyed after this may lose the focus.
    disconnect(qApp, nullptr, this, nullptr);
    letGo();
}

ArmTask ArmServoPanel::task() const {
    return kArmTasks.at(static_cast<std::size_t>(m_task->currentIndex()));
}

double ArmServoPanel::force_N() const {
    return m_force->value();
}

void ArmServoPanel::take() {
    const bool held = m_key || m_button->isHeld();
    if (std::exchange(m_held, held) != held)
        emit heldChanged(held);
}

void ArmServoPanel::letGo() {
    m_key = false;
    m_button->letGo();
    take();
}

void ArmServoPanel::setRefusal(const QString& reason) {
    letGo();
    m_refusal = reason;
    for (QWidget* part :
         {static_cast<QWidget*>(m_task), static_cast<QWidget*>(m_force), static_cast<QWidget*>(m_button)})
        part->setEnabled(reason.isEmpty());
    showTexts();
}

void ArmServoPanel::setState(const ArmServo& servo, const ArmServoStep& step, const QString& hindrance) {
    m_shownStage = servo.stage();
    m_shownEnding = servo.ending();
    m_hindrance = hindrance;
    m_output = step.output;
    m_felt_N = step.force_N;
    showTexts();
}

void ArmServoPanel::showTexts() {
    if (!m_refusal.isEmpty()) {
        m_stage->setText(tr("No servo task is possible: %1.").arg(m_refusal));
        m_what->clear();
        m_ending->clear();
        return;
    }
    const bool ofArm = m_shownStage == Stage::rehearsed || m_shownStage == Stage::driving;
    m_stage->setText(ArmServoTexts::stage(m_shownStage, task()));
    base::setTextColour(m_stage,
                        ofArm ? base::statusColours(palette()).lost : palette().color(QPalette::WindowText));
    m_button->setText(ofArm ? tr("Hold to move the arm (or Space)") : tr("Hold to rehearse (or Space)"));
    m_ending->setText(ArmServoTexts::ending(m_shownEnding, m_hindrance));
    m_ending->setVisible(!m_ending->text().isEmpty());
    base::setTextColour(m_ending, m_shownEnding == Ending::finished ? base::statusColours(palette()).live
                                                                    : base::statusColours(palette()).stale);
    const bool runs = m_shownStage == Stage::rehearsing || m_shownStage == Stage::driving;
    m_what->setVisible(runs);
    if (!runs)
        return;
    QString what =
        tr("%1, %2, force %3", "a task, whether there is contact")
            .arg(servo::ServoTexts::task(m_output.kind), servo::ServoTexts::contact(m_output.contact),
                 base::withUnit(base::fixedDigits(m_felt_N, 1), QStringLiteral("N")));
    if (m_output.limits.any())
        what = tr("%1. Limits that act: %2").arg(what, servo::ServoTexts::limits(m_output.limits));
    m_what->setText(what);
}

void ArmServoPanel::retranslate() {
    setAccessibleName(tr("Servo task on the arm"));
    setWhatsThis(
        tr("<p>Lets the arm do a task by what its pad feels. The first press is a rehearsal on a shadow "
           "of the arm, the second one moves the arm. It moves only while you hold the button, or "
           "Space.</p>"));
    m_title->setText(tr("Servo task"));
    static_cast<QLabel*>(m_form->labelForField(m_task))->setText(tr("&Task"));
    static_cast<QLabel*>(m_form->labelForField(m_force))->setText(tr("F&orce"));
    m_force->setSuffix(QStringLiteral(" N"));
    for (std::size_t i = 0; i < kArmTasks.size(); ++i)
        m_task->setItemText(static_cast<int>(i), ArmServoTexts::task(kArmTasks.at(i)));
    m_task->setAccessibleName(tr("Servo task"));
    m_force->setAccessibleName(tr("Force with which the pad presses"));
    m_button->setAccessibleName(tr("Dead-man switch of the servo task"));
    m_button->setToolTip(tr("Dead-man switch: the task runs only while this button or Space is held"));
    showTexts();
}

bool ArmServoPanel::event(QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (!key.isAutoRepeat()) {
            m_key =
                event->type() == QEvent::KeyPress && m_refusal.isEmpty() && key.modifiers() == Qt::NoModifier;
            take();
        }
        return true;
    }
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::FocusOut)
        letGo();
    return QWidget::event(event);
}

void ArmServoPanel::hideEvent(QHideEvent* event) {
    letGo();
    QWidget::hideEvent(event);
}

void ArmServoPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::EnabledChange && !isEnabled())
        letGo();
    else if (event->type() == QEvent::PaletteChange)
        showTexts();
}

} // namespace teleta::arm_servo
