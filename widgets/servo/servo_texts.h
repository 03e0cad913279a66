// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/cycle_times.h"
#include "backend/servo/servo_controller.h"
#include "backend/servo/task_verdict.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::servo {

/// Translated texts about a servo.
class ServoTexts {
    Q_DECLARE_TR_FUNCTIONS(ServoTexts)

public:
    [[nodiscard]] static QString task(TaskKind kind);
    [[nodiscard]] static QString contact(ContactState state);
    [[nodiscard]] static QString limit(Limit limit);
    /// Names of the active limits, separated by commas; empty if there are none.
    [[nodiscard]] static QString limits(const ActiveLimits& limits);
    /// Whether the task is done, and the reason if it is not.
    [[nodiscard]] static QString verdict(const TaskVerdict& verdict);
    /// Computing time of a simulated cycle and of its parts; empty when no cycle was timed.
    [[nodiscard]] static QString cost(const CycleTimes& times, double rate_Hz);
    /// Name of a run in a chart. number: among the runs of the same source. unbalanced, balanced: whether
    /// tasks that the moment can turn were done without and with it.
    [[nodiscard]] static QString run(const QString& source, int number, bool unbalanced, bool balanced);
    /// Name of row 0..5 of the features, for an edge or a point.
    [[nodiscard]] static QString feature(int row, bool edge);
};

} // namespace teleta::servo
