// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_servo/arm_servo.h"
#include "backend/servo/servo_controller.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace teleta::base {
class HoldButton;
}

namespace teleta::arm_servo {

/// Servo tasks on an arm with a pad: a list of the tasks, the force, and a dead-man switch, the button on the
/// screen or Space while the panel has the keyboard. The switch is let go when the button or the key is, when
/// the panel loses the keyboard or its window, and when it is hidden or disabled; a key that is still down
/// does not hold it again. Knows no arm: what is held and chosen is emitted. Thread: GUI.
class ArmServoPanel : public QWidget {
    Q_OBJECT
public:
    explicit ArmServoPanel(QWidget* parent = nullptr);
    ~ArmServoPanel() override;

    /// What the servo does now. hindrance: why the arm takes no commands; empty: nothing is in the way.
    void setState(const ArmServo& servo, const ArmServoStep& step, const QString& hindrance);
    /// Why there is no servo; a sentence without a full stop.
    void setRefusal(const QString& reason);

    [[nodiscard]] bool isHeld() const { return m_held; }
    void letGo();
    [[nodiscard]] ArmTask task() const;
    [[nodiscard]] double force_N() const;

signals:
    void heldChanged(bool held);
    void taskChanged(teleta::arm_servo::ArmTask task, double force_N);

protected:
    bool event(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void take();
    void retranslate();
    void showTexts();

    QLabel* m_title;
    QComboBox* m_task;
    QDoubleSpinBox* m_force;
    QFormLayout* m_form;
    base::HoldButton* m_button;
    QLabel* m_stage;
    QLabel* m_what;
    QLabel* m_ending;
    bool m_key = false;
    bool m_held = false;
    QString m_refusal;
    QString m_hindrance;
    Stage m_shownStage = Stage::idle;
    Ending m_shownEnding = Ending::none;
    servo::ServoOutput m_output;
    double m_felt_N = 0.0;
};

} // namespace teleta::arm_servo
