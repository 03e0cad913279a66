// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/number_format.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"

#include <array>
#include <cmath>

namespace teleta::base {

namespace {

constexpr QChar kMinus(0x2212);
constexpr QChar kNoBreakSpace(0x00a0);

QString filled(QString text) {
    return text.rightJustified(kNumberWidth, kFigureSpace);
}

/// Step between two neighbouring texts of threeDigits().
double threeDigitResolution(double value) {
    constexpr std::array<double, 3> kSteps{1.0, 0.1, 0.01};
    return kSteps[static_cast<std::size_t>(threeDigitDecimals(value))];
}

QString undefinedText() {
    return filled(QString(QChar(0x2014)));
}

} // namespace

QString threeDigits(std::optional<double> value) {
    if (!value || std::isnan(*value))
        return undefinedText();
    if (std::isinf(*value))
        return filled(*value < 0.0 ? QString(kMinus) + QChar(0x221e) : QString(QChar(0x221e)));
    return filled(fixedDigits(*value, threeDigitDecimals(*value)));
}

QString wholeNumber(std::optional<double> value) {
    if (!value || !std::isfinite(*value))
        return undefinedText();
    return filled(fixedDigits(*value, 0));
}

QString siQuantity(std::optional<double> value, const QString& unit) {
    if (!value || !std::isfinite(*value))
        return undefinedText() + kNoBreakSpace + kFigureSpace + unit;
    const auto [mantissa, prefix] = siNumber(*value);
    return filled(fixedDigits(mantissa, threeDigitDecimals(mantissa))) + kNoBreakSpace +
           (prefix != 0 ? QChar(prefix) : kFigureSpace) + unit;
}

QString withUnit(const QString& number, const QString& unit) {
    const bool close = unit.isEmpty() || unit == QChar(0x00b0);
    return close ? number + unit : number + kNoBreakSpace + unit;
}

QString shortCount(quint64 count) {
    constexpr std::array<char16_t, 4> kSuffixes{u'k', u'M', u'G', u'T'};
    if (count < 1000)
        return QString::number(count);
    quint64 scale = 1000;
    std::size_t index = 0;
    while (count / scale >= 1000 && index + 1 < kSuffixes.size()) {
        scale *= 1000;
        ++index;
    }
    const double mantissa = static_cast<double>(count) / static_cast<double>(scale);
    const int decimals = mantissa < 10.0 ? 2 : mantissa < 100.0 ? 1 : 0;
    const double step = std::pow(10.0, decimals);
    // The small term keeps rounding errors from turning exact counts such as 1230 into the next lower step.
    const double down = std::floor(mantissa * step + 1e-9) / step;
    return fixedDigits(down, decimals) + kNoBreakSpace + QChar(kSuffixes[index]);
}

bool SteadyNumber::update(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) {
        const bool changed = m_shown.has_value();
        m_shown.reset();
        return changed;
    }
    if (m_shown) {
        const double step = m_resolution > 0.0 ? m_resolution : threeDigitResolution(*m_shown);
        if (std::abs(*value - *m_shown) < step)
            return false;
    }
    const double step = m_resolution > 0.0 ? m_resolution : threeDigitResolution(*value);
    const double rounded = std::round(*value / step) * step;
    const bool changed = m_shown != rounded;
    m_shown = rounded;
    return changed;
}

QString SteadyNumber::text() const {
    return m_resolution >= 1.0 ? wholeNumber(m_shown) : threeDigits(m_shown);
}

} // namespace teleta::base
