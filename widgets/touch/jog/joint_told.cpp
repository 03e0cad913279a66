// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/joint_told.h"

#include <QStringList>

#include <numbers>

namespace teleta::touch {

JointTold::JointTold(QWidget* parent)
    : QLabel(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    hide();
}

void JointTold::tell(std::optional<double> rate_radPerS, std::optional<double> effort, bool isCurrent) {
    const bool turns = m_unit == JointRange::Unit::degree;
    if (rate_radPerS)
        rate_radPerS = *rate_radPerS * (turns ? 180.0 / std::numbers::pi : 1e3);
    const bool moved = m_rate.update(rate_radPerS);
    const bool loaded = m_effort.update(effort);
    if (!moved && !loaded)
        return;
    QStringList parts;
    if (m_rate.shown())
        parts << base::withUnit(m_rate.text(), turns ? QStringLiteral("\u00b0/s") : QStringLiteral("mm/s"));
    if (m_effort.shown())
        parts << base::withUnit(m_effort.text(), isCurrent ? QStringLiteral("A")
                                                 : turns   ? QStringLiteral("Nm")
                                                           : QStringLiteral("N"));
    setText(parts.join(QStringLiteral("  ")));
}

} // namespace teleta::touch
