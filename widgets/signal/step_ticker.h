// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace teleta::signal {

/// Ticks with as many decimals as their step needs, so that neighbours differ however far the axis is zoomed.
class StepTicker : public QCPAxisTicker {
protected:
    [[nodiscard]] double getTickStep(const QCPRange& range) override;
    [[nodiscard]] QString getTickLabel(double tick, const QLocale& locale, QChar format,
                                       int precision) override;

private:
    double m_step = 1.0;
};

/// Ticks of clock times, Unix times in s, in the zone of the computer: with as many decimals as their step
/// needs, and with the date where it is longer than a day.
class ClockTicker : public QCPAxisTickerDateTime {
protected:
    [[nodiscard]] double getTickStep(const QCPRange& range) override;
};

} // namespace teleta::signal
