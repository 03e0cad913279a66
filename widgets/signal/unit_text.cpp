// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/unit_text.h"

namespace teleta::signal {

QString unitText(const QString& unit) {
    if (unit == QLatin1String("degC"))
        return QStringLiteral("\u00b0C");
    QString text = unit;
    return text.replace(QLatin1Char('2'), QChar(0x00B2));
}

QString unitPerSecond(const QString& unit) {
    return (unit.isEmpty() ? QStringLiteral("1") : unit) + QStringLiteral("/s");
}

} // namespace teleta::signal
