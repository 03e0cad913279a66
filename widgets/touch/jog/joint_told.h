// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/numbers/number_format.h"
#include "widgets/touch/jog/joint_range.h"

#include <QLabel>

#include <optional>

namespace teleta::touch {

/// Speed and effort of a joint as the arm tells them: "12.3 °/s  1.50 A". Hidden while it tells neither.
/// Thread: GUI.
class JointTold : public QLabel {
    Q_OBJECT
public:
    explicit JointTold(QWidget* parent = nullptr);

    /// What the joint turns or slides by.
    void setUnit(JointRange::Unit unit) { m_unit = unit; }
    /// rate_radPerS: m/s of one that slides. effort: Nm, N of one that slides, or A. Empty: not told.
    void tell(std::optional<double> rate_radPerS, std::optional<double> effort, bool isCurrent);
    [[nodiscard]] bool isEmpty() const { return text().isEmpty(); }

private:
    JointRange::Unit m_unit = JointRange::Unit::degree;
    base::SteadyNumber m_rate{0.1};
    base::SteadyNumber m_effort;
};

} // namespace teleta::touch
