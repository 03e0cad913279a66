// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/touch/gauge_content.h"

#include <QFontMetricsF>
#include <QPalette>
#include <QRectF>

#include <cstddef>
#include <optional>

class QPainter;

namespace teleta::touch {

/// Where the parts of the gauge lie. In a low one details, the numbers of the scale, the names of its bands
/// and a lane of its own for the interval go, in this order: those that went have no height. Thread: any
/// (pure).
class GaugeLayout {
public:
    /// Ends of the scale.
    static constexpr double kLowest_NPerM = 100.0;
    static constexpr double kHighest_NPerM = 1e5;

    GaugeLayout(const QRectF& rect, const QFont& font);

    /// Place of a stiffness on the scale, at its end for one beyond it.
    [[nodiscard]] double x(double stiffness_NPerM) const;
    /// The part of the scale that belongs to a class, 0 the softest.
    [[nodiscard]] QRectF band(std::size_t index) const;
    [[nodiscard]] std::optional<std::size_t> bandAt(const QPointF& point) const;

    double em = 16.0;
    QRectF headline, material, names, interval, bands, axis, details;
};

/// Draws the gauge. Thread: GUI (fonts).
void paintGauge(QPainter& painter, const GaugeLayout& layout, const QFont& font, const GaugeContent& content,
                const QPalette& palette);

} // namespace teleta::touch
