// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/step_ticker.h"

#include <algorithm>
#include <cmath>

namespace teleta::signal {

namespace {

constexpr int kMostDecimals = 6;
constexpr double kLargest = 1e7; // beyond it, powers of ten

} // namespace

double StepTicker::getTickStep(const QCPRange& range) {
    m_step = QCPAxisTicker::getTickStep(range);
    return m_step;
}

QString StepTicker::getTickLabel(double tick, const QLocale& locale, QChar /*format*/, int /*precision*/) {
    const double value = std::abs(tick) < 1e-6 * m_step ? 0.0 : tick;
    // A step of 2.5 needs one decimal more than one of 2.
    int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(m_step))));
    const double unit = std::pow(10.0, -decimals);
    if (std::abs(m_step / unit - std::round(m_step / unit)) > 0.01)
        ++decimals;
    const bool plain = decimals <= kMostDecimals && std::abs(value) < kLargest;
    return (plain ? locale.toString(value, 'f', decimals) : locale.toString(value, 'g', 4))
        .replace(QLatin1Char('-'), QChar(0x2212));
}

double ClockTicker::getTickStep(const QCPRange& range) {
    constexpr double kDay_s = 86'400.0;
    const double step_s = QCPAxisTickerDateTime::getTickStep(range);
    setDateTimeFormat(range.size() > kDay_s ? QStringLiteral("yyyy-MM-dd\nHH:mm")
                      : step_s < 1.0        ? QStringLiteral("HH:mm:ss.zzz")
                                            : QStringLiteral("HH:mm:ss"));
    return step_s;
}

} // namespace teleta::signal
