// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/jog_panel.h"

#include "backend/arm/jog_rates.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/tip_motion.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "widgets/touch/jog/drive_sign.h"
#include "widgets/touch/jog/jog_keys.h"
#include "widgets/touch/jog/joint_range.h"
#include "widgets/touch/jog/joint_told.h"
#include "widgets/touch/jog/limit_line.h"

#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

namespace teleta::touch {

using core::JointVector;

namespace {

/// Shown while no arm is there.
constexpr std::size_t kUsualJoints = 4;
constexpr int kFirstSpeed_percent = 20;
constexpr double kTouchTarget_em = 2.2;
constexpr double kLowTarget_em = 1.8;
constexpr double kDirection_em = 3.4; ///< width
constexpr double kNarrowDirection_em = 2.4;

constexpr Qt::KeyboardModifiers kShortcutModifiers = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

} // namespace

JogPanel::JogPanel(QWidget* parent)
    : QWidget(parent)
    , m_message(new QLabel(this))
    , m_limits(new LimitLine(this))
    , m_wrench(new QLabel(this))
    , m_handText(new QLabel(this))
    , m_driveSign(new DriveSign(this))
    , m_run(new QPushButton(base::themeIcon(base::Icon::play), {}, this))
    , m_hold(new QPushButton(base::themeIcon(base::Icon::pause), {}, this))
    , m_restart(new QPushButton(base::themeIcon(base::Icon::toStart), {}, this))
    , m_modeBox(new QComboBox(this))
    , m_wayBox(new QComboBox(this))
    , m_speed(new QSlider(Qt::Horizontal, this))
    , m_speedLabel(new QLabel(this))
    , m_speedText(new QLabel(this))
    , m_deadMan(new base::HoldButton(this))
    , m_clutch(new base::HoldButton(this))
    , m_grid(new QGridLayout) {
    setFocusPolicy(Qt::StrongFocus);
    m_run->setObjectName(QStringLiteral("run"));
    m_hold->setObjectName(QStringLiteral("hold"));
    m_restart->setObjectName(QStringLiteral("restart"));
    m_deadMan->setObjectName(QStringLiteral("deadMan"));
    m_message->setWordWrap(true);
    m_wrench->setObjectName(QStringLiteral("wrench"));
    m_wrench->setWordWrap(true);
    m_wrench->hide();
    m_handText->setWordWrap(true);
    m_handText->hide();
    m_modeBox->addItems({QString(), QString()});
    m_wayBox->addItems({QString(), QString()});
    m_speed->setRange(1, 100);
    m_speed->setValue(kFirstSpeed_percent);
    m_speedLabel->setBuddy(m_speed);
    m_speedText->setMinimumWidth(base::em(this, 4.0));

    auto* program = new QHBoxLayout;
    program->addWidget(m_driveSign, 1);
    for (QPushButton* button : {m_run, m_hold, m_restart}) {
        button->setAutoDefault(false);
        program->addWidget(button);
    }
    m_grid->setHorizontalSpacing(base::grid(this));
    m_grid->setVerticalSpacing(base::grid(this, 0.5));
    m_grid->setColumnStretch(1, 1);
    addRows();
    auto* kind = new QHBoxLayout;
    kind->addWidget(m_modeBox, 1);
    kind->addWidget(m_wayBox, 1);
    auto* hold = new QHBoxLayout;
    hold->addWidget(m_deadMan, 2);
    hold->addWidget(m_clutch, 1);
    auto* speed = new QHBoxLayout;
    speed->addSpacing(base::grid(this));
    speed->addWidget(m_speedLabel);
    speed->addWidget(m_speed, 1);
    speed->addWidget(m_speedText);
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
    layout->setSpacing(margin / 2);
    layout->addLayout(program);
    layout->addWidget(m_message);
    // What moves the arm comes first: the panel may have to be low.
    layout->addLayout(m_grid);
    layout->addLayout(hold);
    layout->addLayout(kind);
    layout->addLayout(speed);
    layout->addWidget(m_limits);
    layout->addWidget(m_wrench);
    layout->addWidget(m_handText);
    layout->addStretch(1);

    for (QWidget* child : findChildren<QWidget*>())
        child->installEventFilter(this);
    m_rate = noRate();
    m_timer.setInterval(kPeriod_ms);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        take();
        if (isMoving())
            emit jogRequested(m_rate);
    });
    for (base::HoldButton* button : {m_deadMan, m_clutch})
        connect(button, &base::HoldButton::heldChanged, this, [this] {
            setFocus(Qt::MouseFocusReason);
            take();
        });
    connect(m_speed, &QSlider::valueChanged, this, [this] {
        showSpeed();
        // The same deflection would be another place.
        if (m_leader == Leader::hand)
            m_guide.letGo();
        take();
    });
    connect(m_modeBox, &QComboBox::currentIndexChanged, this,
            [this](int index) { setMode(index == 1 ? Mode::tip : Mode::joints); });
    connect(m_wayBox, &QComboBox::currentIndexChanged, this,
            [this](int index) { setWay(index == 1 ? Way::position : Way::velocity); });
    connect(m_run, &QPushButton::clicked, this, [this] { emit programRunRequested(true); });
    connect(m_hold, &QPushButton::clicked, this, [this] { emit programRunRequested(false); });
    connect(m_restart, &QPushButton::clicked, this, &JogPanel::programRestartRequested);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now != this && !(now && isAncestorOf(now)))
            releaseAll();
        showHint();
    });
    retranslate();
    enableParts();
}

JogPanel::~JogPanel() {
    // The parts that are destroyed after this may lose the focus.
    disconnect(qApp, nullptr, this, nullptr);
    releaseAll();
}

void JogPanel::addRows() {
    while (m_rows.size() < std::max(joints(), kTipKeys.size())) {
        const int row = static_cast<int>(m_rows.size());
        Row& added = m_rows.emplace_back(
            Row{new QLabel(this), new JointRange(this), new JointTold(this), new QLabel(this), {}});
        added.range->setObjectName(QStringLiteral("range%1").arg(row));
        m_grid->addWidget(added.name, row, 0);
        added.place->setObjectName(QStringLiteral("place%1").arg(row));
        added.place->hide();
        m_grid->addWidget(added.range, row, 1);
        m_grid->addWidget(added.place, row, 1);
        added.told->setObjectName(QStringLiteral("told%1").arg(row));
        m_grid->addWidget(added.told, row, 4);
        for (const int side : {0, 1}) {
            auto* button = new base::HoldButton(this);
            button->setObjectName((side == 1 ? QStringLiteral("up%1") : QStringLiteral("down%1")).arg(row));
            connect(button, &base::HoldButton::heldChanged, this, &JogPanel::onDirectionHeld);
            added.buttons[static_cast<std::size_t>(side)] = button;
            m_grid->addWidget(button, row, 2 + side);
        }
        for (QWidget* child :
             std::initializer_list<QWidget*>{added.name, added.range, added.buttons[0], added.buttons[1]})
            child->installEventFilter(this);
    }
    fitButtons();
}

void JogPanel::setCompact(bool low, bool narrow) {
    if (std::exchange(m_isLow, low) == low && m_isNarrow == narrow)
        return;
    m_isNarrow = narrow;
    fitButtons();
    showHandText();
    retranslate();
    layout()->activate(); // who shares room asks at once
}

void JogPanel::fitButtons() {
    const int height = base::em(this, m_isLow ? kLowTarget_em : kTouchTarget_em);
    m_deadMan->setMinimumHeight(height);
    m_clutch->setMinimumHeight(height);
    for (const Row& row : m_rows) {
        row.range->setNarrow(m_isNarrow);
        for (base::HoldButton* button : row.buttons)
            button->setFixedSize(base::em(this, m_isNarrow ? kNarrowDirection_em : kDirection_em), height);
    }
}

std::size_t JogPanel::joints() const {
    return m_arm ? m_arm->joints() : kUsualJoints;
}

std::size_t JogPanel::axes() const {
    return m_mode == Mode::joints ? joints() : kTipKeys.size();
}

base::HoldButton* JogPanel::directionButton(std::size_t axis, bool up) const {
    return m_rows[axis].buttons[up ? 1 : 0];
}

QString JogPanel::refusal() const {
    if (!m_arm)
        return tr("No arm is connected. Open a scene or a device with an arm.");
    if (m_arm->recorded)
        return tr("A recording is played: what its arm did is over, and nothing can be moved.");
    if (m_stopEngaged)
        return tr("STOP is engaged. Hold the STOP button to release it, then jog.");
    if (m_readingsOld)
        return tr("The joint readings are old: nothing is moved until they come again.");
    return {};
}

void JogPanel::enableParts() {
    const QString reason = refusal();
    const bool able = reason.isEmpty();
    const bool isRecorded = m_arm && m_arm->recorded;
    if (!able) {
        m_handReady = false;
        releaseAll();
    }
    const bool tip = m_mode == Mode::tip;
    showHint();
    const bool warns = !able || !m_hindrance.isEmpty() || (m_arm && !m_arm->guarded);
    base::setTextColour(m_message, isRecorded ? palette().color(QPalette::PlaceholderText)
                                   : warns    ? base::statusColours(palette()).lost
                                              : palette().color(QPalette::PlaceholderText));
    m_deadMan->setEnabled(able);
    m_clutch->setEnabled(able && m_way == Way::position);
    for (std::size_t axis = 0; axis < m_rows.size(); ++axis) {
        const Row& row = m_rows[axis];
        row.name->setVisible(axis < (tip ? axes() : joints()));
        row.range->setVisible(!tip && axis < joints());
        row.told->setVisible(!tip && axis < joints() && !row.told->isEmpty());
        row.place->setVisible(tip && axis < axes());
        row.range->setEnabled(m_arm.has_value());
        for (base::HoldButton* button : row.buttons) {
            button->setEnabled(able);
            button->setVisible(axis < axes());
        }
    }
    for (QPushButton* button : {m_run, m_hold, m_restart})
        button->setEnabled(able && m_arm->hasProgram);
    // What can only make it safer stays possible.
    m_hold->setEnabled(m_arm && m_arm->hasProgram && !isRecorded && !m_stopEngaged);
}

void JogPanel::setArm(const std::optional<core::ArmDescription>& arm,
                      std::shared_ptr<const arm_model::SerialChain> chain) {
    m_handReady = false;
    releaseAll();
    m_arm = arm;
    m_chain = std::move(chain);
    m_hindrance.clear();
    m_rate = noRate();
    m_hasSample = false;
    m_readingsOld = false;
    m_age_s = 0.0;
    m_limits->forget();
    addRows();
    for (std::size_t joint = 0; joint < m_rows.size(); ++joint) {
        JointRange& range = *m_rows[joint].range;
        const bool slides =
            m_chain && joint < joints() && m_chain->joint(joint).type == arm_model::JointType::prismatic;
        const JointRange::Unit unit = slides ? JointRange::Unit::millimetre : JointRange::Unit::degree;
        range.setUnit(unit);
        m_rows[joint].told->setUnit(unit);
        m_rows[joint].told->tell({}, {}, false);
        range.setRange(arm ? arm->lowest_rad[joint] : 0.0, arm ? arm->highest_rad[joint] : 0.0);
        range.setAngle(std::numeric_limits<double>::quiet_NaN());
    }
    if (!arm)
        m_driveSign->setDrive(std::nullopt);
    const bool tip = canMoveTip();
    m_modeBox->setEnabled(tip);
    if (!tip)
        setMode(Mode::joints);
    retranslate();
}

void JogPanel::setSample(const core::JointSample& sample) {
    if (!m_arm)
        return;
    m_sample = sample;
    m_hasSample = true;
    for (std::size_t joint = 0; joint < std::min(joints(), sample.angle_rad.size()); ++joint)
        m_rows[joint].range->setAngle(sample.angle_rad[joint]);
    showTip();
}

void JogPanel::setDrive(core::ArmDrive drive) {
    if (m_arm)
        m_driveSign->setDrive(drive);
}

void JogPanel::setStopEngaged(bool engaged) {
    if (std::exchange(m_stopEngaged, engaged) != engaged)
        enableParts();
}

void JogPanel::setReadingsOld(bool old) {
    if (std::exchange(m_readingsOld, old) != old)
        enableParts();
}

void JogPanel::setHindrance(const QString& reason) {
    if (std::exchange(m_hindrance, reason) != reason)
        enableParts();
}

void JogPanel::setHand(const std::optional<HandMotion>& hand) {
    m_hand = hand.value_or(HandMotion{});
    if (std::exchange(m_hasHand, hand.has_value()) != hand.has_value())
        showHandText();
    m_handReady = hand && (m_handReady || !m_hand.deadManHeld);
    take();
}

void JogPanel::setHandText(const QString& text) {
    m_handText->setText(text);
    showHandText();
}

/// Where there is little room, a line that says that there is none is left out.
void JogPanel::showHandText() {
    m_handText->setVisible(!m_handText->text().isEmpty() && (!m_isLow || m_hasHand));
}

void JogPanel::setWrench(const std::optional<core::WrenchSample>& wrench) {
    const auto sizeOf = [](const std::array<double, 3>& axes) {
        return Eigen::Vector3d::Map(axes.data()).norm();
    };
    const bool changed = m_force_N.update(wrench ? std::optional(sizeOf(wrench->force_N)) : std::nullopt);
    const bool turned = m_torque_Nm.update(wrench ? std::optional(sizeOf(wrench->torque_Nm)) : std::nullopt);
    if (changed || turned)
        showWrench();
}

void JogPanel::setMode(Mode mode) {
    if (mode == m_mode)
        return;
    releaseAll();
    m_mode = mode;
    m_modeBox->setCurrentIndex(mode == Mode::tip ? 1 : 0);
    retranslate();
    showTip();
}

void JogPanel::setWay(Way way) {
    if (way == m_way)
        return;
    letGo();
    m_way = way;
    m_wayBox->setCurrentIndex(way == Way::position ? 1 : 0);
    retranslate();
}

void JogPanel::setSpeed(int percent) {
    m_speed->setValue(percent);
}

bool JogPanel::isMoving() const {
    return std::ranges::any_of(m_rate, [](double rate) { return rate != 0.0; });
}

bool JogPanel::canMoveTip() const {
    // The recording of an arm without a skin has no lengths.
    const bool hasLengths = !m_arm || (m_arm->upperArmLength_m > 0.0 && m_arm->forearmLength_m > 0.0);
    return m_chain || (hasLengths && arm::canMoveTip(joints()));
}

Eigen::Vector3d JogPanel::tipPosition(const JointVector& angle_rad) const {
    return m_chain ? m_chain->X_Base_Tip(angle_rad).translation().eval()
                   : arm::tipPosition(*m_arm, angle_rad);
}

JointVector JogPanel::tipRates(const JointVector& angle_rad, const Eigen::Vector3d& velocity_mPerS) {
    if (!m_chain)
        return arm::tipRates(*m_arm, angle_rad, velocity_mPerS);
    const arm_model::TipRates rates =
        arm_model::tipRates(*m_chain, angle_rad, {velocity_mPerS, Eigen::Vector3d::Zero()});
    m_singular = rates.singular;
    return rates.rate;
}

JointVector JogPanel::tipRate(const std::array<double, 3>& share) {
    const Eigen::Vector3d velocity =
        0.01 * m_speed->value() * arm::kFullTipSpeed_mPerS * Eigen::Vector3d(share[0], share[1], share[2]);
    return m_hasSample && !velocity.isZero() ? tipRates(m_sample.angle_rad, velocity) : noRate();
}

/// The tip is led from where it is when another one takes over: his hand is elsewhere.
void JogPanel::leadBy(Leader leader) {
    if (leader != m_leader)
        m_guide.letGo();
    m_leader = leader;
}

JointVector JogPanel::guidedRate() {
    const bool byKeys = m_hasSample && m_mode == Mode::tip && (m_shift || m_deadMan->isHeld());
    const bool byHand = m_hasSample && !byKeys && m_handReady && m_hand.deadManHeld;
    const bool clutch = m_clutchKey || m_clutch->isHeld() || (byHand && m_hand.clutchHeld);
    leadBy(byKeys ? Leader::keys : byHand ? Leader::hand : Leader::nobody);
    if (m_leader == Leader::nobody)
        return noRate();
    const double scale_m = byHand ? 0.01 * m_speed->value() * kFullStep_m : 0.0;
    const Eigen::Vector3d hand_m =
        scale_m * Eigen::Vector3d(m_hand.velocity[0], m_hand.velocity[1], m_hand.velocity[2]);
    const Eigen::Vector3d velocity = m_guide.velocity_mPerS(
        true, clutch, hand_m, tipPosition(m_sample.reference_rad), arm::kFullTipSpeed_mPerS, m_age_s);
    return velocity.isZero() ? noRate() : tipRates(m_sample.reference_rad, velocity);
}

void JogPanel::stepBy(std::size_t axis, bool up) {
    if (!isGuided() || !refusal().isEmpty())
        return;
    // The dead man may have come with this press: the tip is taken hold of where it is.
    take();
    if (m_leader != Leader::keys)
        return;
    Eigen::Vector3d by_m = Eigen::Vector3d::Zero();
    by_m[static_cast<Eigen::Index>(axis)] = (up ? 0.01 : -0.01) * m_speed->value() * kFullStep_m;
    m_guide.step(by_m);
}

JointVector JogPanel::wanted() {
    if (!m_arm || m_stopEngaged || m_readingsOld) {
        leadBy(Leader::nobody);
        return noRate();
    }
    const bool byKeys = m_shift || m_deadMan->isHeld();
    if (m_way == Way::position && (isGuided() || !byKeys))
        return guidedRate();
    leadBy(Leader::nobody);
    if (!byKeys)
        return tipRate(handVelocity());
    std::array<double, JointVector::kCapacity> direction{};
    for (std::size_t axis = 0; axis < axes(); ++axis)
        for (const std::size_t side : {0U, 1U})
            if (m_keys[axis][side] || m_rows[axis].buttons[side]->isHeld())
                direction[axis] += side == 1 ? 1.0 : -1.0;
    if (m_mode == Mode::tip)
        return tipRate({direction[0], direction[1], direction[2]});
    JointVector rate = noRate();
    for (std::size_t joint = 0; joint < rate.size(); ++joint)
        rate[joint] = 0.01 * m_speed->value() * direction[joint] * m_arm->fastest_radPerS[joint];
    return rate;
}

void JogPanel::take() {
    m_singular = false;
    const JointVector rate = wanted();
    m_limits->setSingular(m_singular);
    if (rate == m_rate)
        return;
    m_rate = rate;
    if (!isMoving())
        m_timer.stop();
    else if (!m_timer.isActive())
        m_timer.start();
    emit jogRequested(m_rate);
}

void JogPanel::letGo() {
    m_handReady = false;
    releaseAll();
}

void JogPanel::releaseAll() {
    m_shift = false;
    m_keys = {};
    m_clutchKey = false;
    leadBy(Leader::nobody);
    m_deadMan->letGo();
    m_clutch->letGo();
    for (const Row& row : m_rows)
        for (base::HoldButton* button : row.buttons)
            button->letGo();
    take();
}

void JogPanel::onDirectionHeld(bool held, Qt::KeyboardModifiers modifiers) {
    if (held) {
        // Takes the keyboard, so that letting go of Shift is seen.
        setFocus(Qt::MouseFocusReason);
        m_shift = modifiers.testFlag(Qt::ShiftModifier);
        for (std::size_t axis = 0; axis < axes(); ++axis)
            for (const bool up : {false, true})
                if (sender() == directionButton(axis, up))
                    stepBy(axis, up);
    }
    take();
}

bool JogPanel::isOwnKey(int key) const {
    for (std::size_t axis = 0; axis < axes(); ++axis)
        if (const auto keys = keysOf(m_mode == Mode::tip, axis);
            keys && (key == keys->down || key == keys->up))
            return true;
    return key == Qt::Key_Shift || (key == Qt::Key_C && m_way == Way::position);
}

void JogPanel::onKey(const QKeyEvent& event, bool pressed) {
    if (event.key() == Qt::Key_Shift) {
        m_shift = pressed;
    } else {
        // Shift may have been pressed or let go while the keyboard was elsewhere.
        m_shift = event.modifiers().testFlag(Qt::ShiftModifier);
        if (event.key() == Qt::Key_C)
            m_clutchKey = pressed;
        for (std::size_t axis = 0; axis < axes(); ++axis) {
            const auto keys = keysOf(m_mode == Mode::tip, axis);
            if (!keys || (event.key() != keys->down && event.key() != keys->up))
                continue;
            const bool up = event.key() == keys->up;
            if (pressed)
                stepBy(axis, up);
            m_keys[axis][up ? 1 : 0] = pressed && refusal().isEmpty();
        }
    }
    take();
}

bool JogPanel::eventFilter(QObject* watched, QEvent* event) {
    // A menu takes keyboard and mouse without a change of the focus: a release would not be seen any more.
    if (event->type() == QEvent::FocusOut &&
        static_cast<QFocusEvent*>(event)->reason() == Qt::PopupFocusReason)
        releaseAll();
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool pressed = event->type() == QEvent::KeyPress;
        if (isOwnKey(key.key()) && !(pressed && (key.modifiers() & kShortcutModifiers))) {
            if (!key.isAutoRepeat())
                onKey(key, pressed);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

bool JogPanel::event(QEvent* event) {
    if (eventFilter(this, event))
        return true;
    if (event->type() == QEvent::WindowDeactivate)
        releaseAll();
    if (event->type() == QEvent::Resize)
        showHint(); // in another number of lines
    if (event->type() == QEvent::ShortcutOverride) {
        // The letters are the panel's own while it has the focus.
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (isOwnKey(key.key()) && !(key.modifiers() & kShortcutModifiers)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void JogPanel::hideEvent(QHideEvent* event) {
    releaseAll();
    QWidget::hideEvent(event);
}

void JogPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::EnabledChange && !isEnabled())
        releaseAll();
    else if (event->type() == QEvent::PaletteChange)
        enableParts();
}

} // namespace teleta::touch
