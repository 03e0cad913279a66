// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/methods/adaptive/procedure_settings.h"

#include <QString>

#include <utility>
#include <vector>

namespace teleta::study {

/// An axis with round numbers; ends: low < high, with log10 above 0.
struct ChartAxis {
    QString title;
    LevelScale scale = LevelScale::linear;
    double low = 0.0;
    double high = 1.0;
};

/// Axes, and what is drawn between them, in the units of the axes. Thread: one.
class LevelChart {
public:
    static constexpr double kWidth = 560.0;
    static constexpr double kHeight = 400.0;

    LevelChart(const QString& title, ChartAxis x, ChartAxis y);

    /// series: colour, 0 .. 5. area: of the dot, 1 is the usual one. hollow: an outline only.
    void dot(double x, double y, std::size_t series, double area = 1.0, bool hollow = false);
    void diamond(double x, double y, std::size_t series);
    void curve(const std::vector<std::pair<double, double>>& points, std::size_t series);
    /// Filled between two curves of the same x.
    void band(const std::vector<double>& x, const std::vector<Interval>& y, std::size_t series);
    /// A horizontal or vertical bar with ends.
    void barAcross(double y, const Interval& x, std::size_t series);
    void barUp(double x, const Interval& y, std::size_t series);
    /// Dashed lines across the whole chart, named at their end.
    void levelLine(double y, const QString& name);
    void placeLine(double x);
    /// Texts below the title, one after the other.
    void remark(const QString& text);
    /// A dot and its name, above the chart.
    void legend(std::size_t series, const QString& name, bool hollow = false, bool isDiamond = false);
    /// A name below the axis in place of numbers (the axis then has none).
    void category(double x, const QString& name);

    [[nodiscard]] figure::SvgCanvas& canvas() { return m_canvas; }

private:
    [[nodiscard]] double across(double x) const;
    [[nodiscard]] double down(double y) const;
    void drawAxes();

    ChartAxis m_x;
    ChartAxis m_y;
    figure::SvgCanvas m_canvas;
    double m_legend;
    int m_remarks = 0;
};

/// Round numbers of an axis; on a log10 scale 1, 2 and 5 times powers of ten. Thread: any (pure).
[[nodiscard]] std::vector<double> ticksOf(const ChartAxis& axis);

} // namespace teleta::study
