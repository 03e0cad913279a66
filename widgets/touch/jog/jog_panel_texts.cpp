// SPDX-License-Identifier: GPL-3.0-or-later
// What the jog panel says.
#include "backend/arm_model/serial_chain.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/touch/jog/jog_keys.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/jog/joint_range.h"
#include "widgets/touch/jog/joint_told.h"
#include "widgets/touch/jog/limit_line.h"
#include "widgets/touch/touch_texts.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QLocale>
#include <QPushButton>
#include <QSlider>

#include <algorithm>
#include <array>

namespace teleta::touch {

void JogPanel::showSpeed() {
    if (isGuided()) {
        m_speedLabel->setText(tr("&Step"));
        m_speed->setToolTip(tr("How far a press leads the tip, and a 3D mouse that is fully deflected"));
        m_speed->setAccessibleName(tr("Length of a step"));
        m_speedText->setText(base::withUnit(QLocale().toString(10.0 * m_speed->value() * kFullStep_m, 'f', 1),
                                            QStringLiteral("mm")));
    } else {
        m_speedLabel->setText(tr("&Speed"));
        m_speed->setToolTip(tr("Share of the fastest speed"));
        m_speed->setAccessibleName(tr("Jog speed"));
        m_speedText->setText(tr("%1 %").arg(m_speed->value()));
    }
}

void JogPanel::retranslate() {
    setAccessibleName(tr("Jog the arm"));
    setWhatsThis(isGuided()
                     ? tr("<p>Leads the tip of the arm by hand. Each press of a direction is a step. The arm "
                          "moves only while you hold Shift, or the wide button; let go of it and it stands "
                          "still.</p>")
                     : tr("<p>Moves the arm by hand. It moves only while you hold Shift, or the wide button, "
                          "together with a direction. Let go of either and it stands still.</p>"));
    showWrench();
    m_limits->retranslate();
    const auto call = [this](QPushButton* button, const QString& text, const QString& about) {
        const QString plain = QString(text).remove(QLatin1Char('&'));
        button->setText(m_isNarrow ? QString() : text);
        button->setAccessibleName(plain);
        button->setToolTip(m_isNarrow ? tr("%1: %2", "a button and what it does").arg(plain, about) : about);
    };
    call(m_run, tr("R&un"), tr("Let the arm's program go on"));
    call(m_hold, tr("H&old"), tr("Hold the arm where it is"));
    call(m_restart, tr("R&estart"), tr("Restart the arm's program"));
    m_modeBox->setItemText(0, tr("Joints"));
    m_modeBox->setItemText(1, tr("Tip, x y z"));
    m_modeBox->setAccessibleName(tr("What is moved"));
    m_modeBox->setToolTip(tr("Turn single joints, or move the tip of the forearm along the base's axes"));
    m_wayBox->setItemText(0, tr("By velocity"));
    m_wayBox->setItemText(1, tr("By position"));
    m_wayBox->setAccessibleName(tr("How it is moved"));
    m_wayBox->setToolTip(
        tr("By velocity the arm moves while a direction is held. By position each press is a "
           "step of the tip, and a 3D mouse leads the tip as far as it is deflected."));
    m_clutch->setText(tr("Clutch (C)"));
    m_clutch->setToolTip(
        tr("While it is held the arm stands still and the hand goes back freely; then it takes hold anew. "
           "Also the second button of a 3D mouse."));
    m_clutch->setAccessibleName(tr("Clutch"));
    showSpeed();
    m_deadMan->setText(m_isNarrow ? tr("Hold (or Shift)") : tr("Hold to enable (or Shift)"));
    m_deadMan->setToolTip(tr("Dead-man switch: the arm moves only while this button or Shift is held"));
    m_deadMan->setAccessibleName(tr("Dead-man switch"));
    constexpr std::array<char16_t, 3> kAxes{u'x', u'y', u'z'};
    const bool tip = m_mode == Mode::tip;
    for (std::size_t axis = 0; axis < m_rows.size(); ++axis) {
        const QString joint = jointName(axis);
        m_rows[axis].name->setText(tip && axis < axes() ? tr("tip %1").arg(QChar(kAxes[axis])) : joint);
        m_rows[axis].range->setAccessibleName(tr("Angle of %1").arg(joint));
        m_rows[axis].told->setToolTip(tr("Speed and effort of %1, as the arm reports them").arg(joint));
        if (axis >= axes())
            continue;
        const QString name = tip ? tr("tip along %1").arg(QChar(kAxes[axis])) : joint;
        const std::optional<KeyPair> keys = keysOf(tip, axis);
        for (const bool up : {false, true}) {
            base::HoldButton* button = directionButton(axis, up);
            const QString sign = up ? QStringLiteral("+") : QString(QChar(0x2212));
            button->setText(tip ? QChar(kAxes[axis]) + sign : sign);
            button->setAccessibleName(up ? tr("%1 up").arg(name) : tr("%1 down").arg(name));
            button->setToolTip(!keys ? tr("Hold with Shift to move")
                                     : (isGuided() ? tr("A step, while Shift is held; key Shift+%1")
                                                   : tr("Hold with Shift to move; key Shift+%1"))
                                           .arg(QChar(up ? keys->up : keys->down)));
        }
    }
    enableParts();
}

QString JogPanel::jointName(std::size_t joint) const {
    return m_chain && joint < joints() ? QString::fromStdString(m_chain->joint(joint).name)
                                       : TouchTexts::joint(joint, joints());
}

bool JogPanel::hasKeyboard() const {
    const QWidget* focus = QApplication::focusWidget();
    return focus == this || (focus != nullptr && isAncestorOf(focus));
}

/// The keys act in this panel alone, so that nobody moves the arm by typing elsewhere.
void JogPanel::showHint() {
    const QString reason = refusal();
    if (!reason.isEmpty()) {
        m_message->setText(reason);
        return;
    }
    if (!m_hindrance.isEmpty()) {
        m_message->setText(tr("The arm does not move: %1.").arg(m_hindrance));
        return;
    }
    const QString how =
        isGuided() ? tr("Hold Shift: each press of D A (x), W S (y), E Q (z) is a step.")
        : m_mode == Mode::tip
            ? tr("Hold Shift and a button, or Shift with D A (x), W S (y), E Q (z).")
            : (m_isLow ? tr("Hold Shift with %1 (up), %2 (down).")
                       : tr("Hold Shift and a button, or Shift with %1 (up), %2 (down)."))
                  .arg(lettersOf(joints(), &KeyPair::up), lettersOf(joints(), &KeyPair::down));
    const QString first = tr("Click here first: the keys work only in this view. %1");
    const QString longer = first.arg(m_isLow ? QString() : how).trimmed();
    const auto whole = [this](const QString& text) {
        return m_arm && !m_arm->guarded
                   ? tr("UNGUARDED: the robot does not stop by itself when this program or "
                        "the network fails. Keep its emergency stop within reach. %1")
                         .arg(text)
                   : text;
    };
    // What is below must not move under the mouse when the keyboard comes or goes.
    const QMargins margins = layout()->contentsMargins(); // the line itself gets its width later
    int highest = 0;
    for (const QString& text : {how, longer}) {
        m_message->setText(whole(text));
        m_message->setMinimumHeight(0); // which its height for a width would be at least
        highest = std::max(highest, m_message->heightForWidth(width() - margins.left() - margins.right()));
    }
    m_message->setMinimumHeight(highest);
    m_message->setText(whole(hasKeyboard() ? how : longer));
}

void JogPanel::setReport(const core::ArmReport& report) {
    m_limits->setActive(report.activeLimits);
    const auto of = [](const core::JointVector& values, std::size_t joint) {
        return joint < values.size() ? std::optional(values[joint]) : std::nullopt;
    };
    for (std::size_t joint = 0; joint < joints(); ++joint) {
        JointTold& told = *m_rows[joint].told;
        told.tell(of(report.rate_radPerS, joint), of(report.effort, joint), report.effortIsCurrent);
        told.setVisible(m_mode == Mode::joints && !told.isEmpty());
    }
}

void JogPanel::showWrench() {
    m_wrench->setVisible(m_force_N.shown().has_value());
    if (m_force_N.shown())
        m_wrench->setText(tr("At the tip: force %1, torque %2")
                              .arg(base::withUnit(m_force_N.text().trimmed(), QStringLiteral("N")),
                                   base::withUnit(m_torque_Nm.text().trimmed(), QStringLiteral("Nm"))));
}

void JogPanel::showTip() {
    const bool isKnown = m_mode == Mode::tip && m_arm && m_hasSample && canMoveTip();
    const Eigen::Vector3d tip_m = isKnown ? tipPosition(m_sample.angle_rad) : Eigen::Vector3d::Zero().eval();
    for (std::size_t axis = 0; axis < std::min(m_rows.size(), kTipKeys.size()); ++axis)
        m_rows[axis].place->setText(
            isKnown ? base::withUnit(base::fixedDigits(1e3 * tip_m[static_cast<Eigen::Index>(axis)], 1),
                                     QStringLiteral("mm"))
                    : QStringLiteral("\u2013"));
}

} // namespace teleta::touch
