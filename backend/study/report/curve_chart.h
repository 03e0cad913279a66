// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"

#include <QString>

#include <string>
#include <utility>
#include <vector>

namespace teleta::study {

/// Range of an axis; both ends on round numbers after rounding outwards.
struct AxisRange {
    double low = 0.0;
    double high = 1.0;

    /// Ends moved outwards to multiples of a round step, about six steps long. low < high.
    [[nodiscard]] AxisRange rounded() const;
    [[nodiscard]] double step() const;
};

/// A line and its name.
struct NamedCurve {
    std::string name;
    std::vector<std::pair<double, double>> points;
};

/// Draws axes with numbers and lines, which are named in a legend. Thread: one.
class CurveChart {
public:
    CurveChart(const QString& title, const QString& xTitle, const QString& yTitle, AxisRange x, AxisRange y);

    void curve(const NamedCurve& curve);
    /// A vertical bar with ends, in the colour of the curve drawn last.
    void bar(double x, double low, double high);
    /// A horizontal line with a name.
    void level(double y, const QString& name);

    [[nodiscard]] figure::SvgCanvas& canvas() { return m_canvas; }

private:
    [[nodiscard]] double across(double x) const;
    [[nodiscard]] double down(double y) const;

    AxisRange m_x;
    AxisRange m_y;
    figure::SvgCanvas m_canvas;
    std::size_t m_curves = 0;
    double m_legend;
};

} // namespace teleta::study
