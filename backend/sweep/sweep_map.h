// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/sweep/sweep_plan.h"

#include <QString>

#include <functional>
#include <optional>

namespace teleta::sweep {

/// From least to most; of equal or no values a range around them.
struct ValueRange {
    double low = 0.0;
    double high = 1.0;

    [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

/// Where a map lies in a picture, px; with its labels.
struct MapBox {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

/// A map of values over two axes: columns are the values of x, rows those of y with the first at the bottom.
/// at: the value at a column and a row; empty is a hatched field. heading: above it.
void drawMap(figure::SvgCanvas& canvas, const MapBox& box, const SweepAxis& x, const SweepAxis& y,
             const ValueRange& range, const QString& heading,
             const std::function<std::optional<double>(std::size_t column, std::size_t row)>& at);

/// The legend of the maps' colours: a bar with its ends.
void drawMapLegend(figure::SvgCanvas& canvas, double left, double top, double width, const ValueRange& range);

/// A number with three digits as people read it.
[[nodiscard]] QString shortNumber(double value);

} // namespace teleta::sweep
