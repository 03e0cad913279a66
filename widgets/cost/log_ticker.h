// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace teleta::cost {

/// Ticks of a logarithmic axis of quantities, labelled as people write them: "200 µs", "1 mm", "5 %". Decades
/// where the axis has three of them, every second or third one where it has many, else numbers within them.
/// Thread: GUI.
class LogTicker : public QCPAxisTicker {
public:
    /// unit: SI; "1": shares, in percent.
    explicit LogTicker(QString unit)
        : m_unit(std::move(unit)) {}

    /// Ascending; lower, upper: > 0. Empty for a range that is none.
    [[nodiscard]] static QVector<double> ticksWithin(double lower, double upper);
    /// value: three digits at most.
    [[nodiscard]] static QString label(double value, const QString& unit);

protected:
    QVector<double> createTickVector(double step, const QCPRange& range) override;
    QVector<double> createSubTickVector(int count, const QVector<double>& ticks) override;
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

private:
    QString m_unit;
};

} // namespace teleta::cost
