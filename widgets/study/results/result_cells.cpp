// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/result_cells.h"

#include <QLocale>

#include <cmath>

namespace teleta::study {

namespace {

constexpr double kSmallP = 0.001;

} // namespace

ResultCell missing() {
    return {QStringLiteral("\u2013"), QStringLiteral("NA")};
}

ResultCell cell(const std::optional<double>& value, int decimals) {
    if (!value || !std::isfinite(*value))
        return missing();
    return {QLocale().toString(*value, 'f', decimals),
            QLocale::c().toString(*value, 'g', QLocale::FloatingPointShortest)};
}

ResultCell cell(const std::optional<Interval>& interval, int decimals, double factor) {
    if (!interval)
        return missing();
    const QLocale locale;
    const QLocale c = QLocale::c();
    return {QStringLiteral("%1 \u2013 %2")
                .arg(locale.toString(factor * interval->low, 'f', decimals),
                     locale.toString(factor * interval->high, 'f', decimals)),
            QStringLiteral("%1;%2").arg(
                c.toString(factor * interval->low, 'g', QLocale::FloatingPointShortest),
                c.toString(factor * interval->high, 'g', QLocale::FloatingPointShortest))};
}

ResultCell count(std::int64_t value) {
    return {QString::number(value)};
}

QString pText(double p) {
    return p < kSmallP ? QStringLiteral("< %1").arg(QLocale().toString(kSmallP))
                       : QLocale().toString(p, 'f', 3);
}

QString pRelation(double p) {
    return p < kSmallP ? pText(p) : QStringLiteral("= %1").arg(pText(p));
}

ResultCell pCell(const std::optional<double>& p) {
    return p ? ResultCell{pText(*p), QLocale::c().toString(*p, 'g', QLocale::FloatingPointShortest)}
             : missing();
}

} // namespace teleta::study
