// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/quantity_text.h"

#include "backend/core/number_text.h"
#include "widgets/base/numbers/number_format.h"

#include <QLocale>

#include <array>
#include <cmath>

namespace teleta::base {

namespace {

QString magnitude(double value, char format, int precision) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(value), format, precision);
}

QString noValue() {
    return QChar(0x2014);
}

constexpr QChar kMinusSign(0x2212);

} // namespace

SiNumber siNumber(double value) {
    constexpr std::array<char16_t, 9> kPrefixes{u'p', u'n', u'\u00b5', u'm', 0, u'k', u'M', u'G', u'T'};
    constexpr int kNoPrefix = 4;
    int index = kNoPrefix;
    double mantissa = value;
    while (std::abs(mantissa) >= 999.5 && index + 1 < static_cast<int>(kPrefixes.size())) {
        mantissa /= 1000.0;
        ++index;
    }
    while (mantissa != 0.0 && std::abs(mantissa) < 0.9995 && index > 0) {
        mantissa *= 1000.0;
        --index;
    }
    return {mantissa, kPrefixes[static_cast<std::size_t>(index)]};
}

int threeDigitDecimals(double value) {
    const double magnitude = std::abs(value);
    if (magnitude < 9.995)
        return 2;
    return magnitude < 99.95 ? 1 : 0;
}

QString fixedDigits(std::optional<double> value, int decimals) {
    if (!value || !std::isfinite(*value))
        return noValue();
    const bool zero = std::round(std::abs(*value) * std::pow(10.0, decimals)) == 0.0;
    const QString digits = magnitude(*value, 'f', decimals);
    return *value < 0.0 && !zero ? kMinusSign + digits : digits;
}

QString significantDigits(std::optional<double> value, int digits) {
    if (!value || !std::isfinite(*value))
        return noValue();
    const QString text = magnitude(*value, 'g', digits);
    return *value < 0.0 ? kMinusSign + text : text;
}

QString siText(std::optional<double> value, const QString& unit, int moreDigits) {
    if (!value || !std::isfinite(*value))
        return withUnit(noValue(), unit);
    const auto [mantissa, prefix] = siNumber(*value);
    return withUnit(fixedDigits(mantissa, threeDigitDecimals(mantissa) + moreDigits),
                    prefix != 0 ? QString(QChar(prefix)) + unit : unit);
}

QString millimetres(double length_m) {
    return withUnit(threeDigits(1e3 * length_m).trimmed(), QStringLiteral("mm"));
}

QString csvNumber(std::optional<double> value) {
    if (!value || !std::isfinite(*value))
        return QStringLiteral("NA");
    const core::NumberText text(*value);
    return QString::fromLatin1(text.view().data(), static_cast<qsizetype>(text.view().size()));
}

} // namespace teleta::base
