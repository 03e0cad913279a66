// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_servo/arm_servo.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::arm_servo {

/// Words for servo tasks on an arm. Thread: GUI.
class ArmServoTexts {
    Q_DECLARE_TR_FUNCTIONS(ArmServoTexts)
public:
    [[nodiscard]] static QString task(ArmTask task);
    /// What the next press does, or what happens now.
    [[nodiscard]] static QString stage(Stage stage, ArmTask task);
    /// Why the last run ended, a sentence; empty: there was none. hindrance: what the arm says is in the way.
    [[nodiscard]] static QString ending(Ending ending, const QString& hindrance);
};

} // namespace teleta::arm_servo
