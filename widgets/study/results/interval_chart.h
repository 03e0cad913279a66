// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"
#include "backend/study/protocol/trial.h"
#include "widgets/base/figure/figure_view.h"

#include <QPalette>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

class QPainter;

namespace teleta::study {

/// A value with its interval, and the single values behind it.
struct ChartPoint {
    std::optional<double> value;
    std::optional<Interval> interval;
    std::vector<double> single;
};

struct ChartSeries {
    QString name;
    std::vector<ChartPoint> points; ///< one per category
};

/// Values in categories side by side: bars with their intervals, single participants as dots.
struct IntervalChartContent {
    QString name; ///< of the file
    QString title;
    QString axis;         ///< with its unit
    double highest = 1.0; ///< of the axis, which begins at 0
    QStringList categories;
    QStringList notes; ///< below the categories, for example p values; may be empty
    std::vector<ChartSeries> series;
    std::optional<double> reference; ///< a line across, for example chance
    QString referenceName;
    Mode mode = Mode::run;
};

void paintIntervalChart(QPainter& painter, const QRectF& rect, const IntervalChartContent& content,
                        const QPalette& palette);

/// category,series,value,low,high,singles; C locale, NA for missing values.
[[nodiscard]] QString intervalChartCsv(const IntervalChartContent& content);

/// The chart as a widget that can be copied and saved. Thread: GUI.
class IntervalChart : public base::FigureView {
    Q_OBJECT

public:
    explicit IntervalChart(QWidget* parent = nullptr);

    void setContent(IntervalChartContent content);
    [[nodiscard]] const IntervalChartContent& content() const { return m_content; }
    [[nodiscard]] base::Figure figure() override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    IntervalChartContent m_content;
};

} // namespace teleta::study
