// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cost/log_ticker.h"

#include "widgets/base/numbers/number_format.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace teleta::cost {

namespace {

constexpr int kEnoughDecades = 3;
constexpr int kMostDecades = 8;

QVector<double> multiples(double lower, double upper, std::initializer_list<double> factors, int step = 1) {
    QVector<double> ticks;
    int first = static_cast<int>(std::floor(std::log10(lower)));
    while (first % step != 0)
        --first;
    const int last = static_cast<int>(std::ceil(std::log10(upper)));
    for (int exponent = first; exponent <= last; exponent += step)
        for (const double factor : factors) {
            const double tick = factor * std::pow(10.0, exponent);
            if (tick >= lower && tick <= upper)
                ticks.append(tick);
        }
    return ticks;
}

} // namespace

QVector<double> LogTicker::ticksWithin(double lower, double upper) {
    if (!(lower > 0.0) || !(upper > lower) || !std::isfinite(upper))
        return {};
    const double decades = std::log10(upper / lower);
    if (decades > kMostDecades)
        return multiples(lower, upper, {1.0}, static_cast<int>(std::ceil(decades / kMostDecades)));
    const QVector<double> whole = multiples(lower, upper, {1.0});
    if (whole.size() >= kEnoughDecades)
        return whole;
    return multiples(lower, upper, {1.0, 2.0, 5.0});
}

QString LogTicker::label(double value, const QString& unit) {
    struct Prefix {
        double size;
        char16_t letter;
    };
    constexpr std::array kPrefixes{Prefix{1e-12, u'p'}, Prefix{1e-9, u'n'}, Prefix{1e-6, u'\u00b5'},
                                   Prefix{1e-3, u'm'},  Prefix{1.0, 0},     Prefix{1e3, u'k'}};
    constexpr double kRounding = 1.0 - 1e-9;
    const bool isShare = unit == QStringLiteral("1");
    const double number = isShare ? 100.0 * value : value;
    if (isShare && number >= 1e-3 * kRounding)
        return base::withUnit(QLocale().toString(number, 'g', 3), QStringLiteral("%"));
    if (isShare || number < kPrefixes.front().size * kRounding)
        return base::withUnit(QLocale::c().toString(number, 'e', 0), isShare ? QStringLiteral("%") : unit);
    const Prefix* best = kPrefixes.begin();
    for (const Prefix& prefix : kPrefixes)
        if (number >= prefix.size * kRounding)
            best = &prefix;
    const QString prefixed = best->letter == 0 ? unit : QChar(best->letter) + unit;
    return base::withUnit(QLocale().toString(number / best->size, 'g', 3), prefixed);
}

QVector<double> LogTicker::createTickVector(double, const QCPRange& range) {
    return ticksWithin(range.lower, range.upper);
}

QVector<double> LogTicker::createSubTickVector(int, const QVector<double>& ticks) {
    if (ticks.size() < 2)
        return {};
    return multiples(0.1 * ticks.front(), 10.0 * ticks.back(), {2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0});
}

QString LogTicker::getTickLabel(double tick, const QLocale&, QChar, int) {
    return label(tick, m_unit);
}

} // namespace teleta::cost
