// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::base {

/// A unit as the end of the name of a column: lower case, "u" for micro, "_" for all that is no letter or
/// digit: "n", "ut", "counts". An empty unit is "counts". Thread: any (pure).
[[nodiscard]] inline QString columnUnit(const QString& unit) {
    if (unit.isEmpty())
        return QStringLiteral("counts");
    QString name;
    for (const QChar c : unit.toLower()) {
        if (c == QChar(0x00b5) || c == QChar(0x03bc))
            name += QLatin1Char('u');
        else
            name += c.unicode() < 128 && c.isLetterOrNumber() ? c : QLatin1Char('_');
    }
    return name;
}

} // namespace teleta::base
