// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_layout.h"

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

namespace {

/// Centre along one axis so that the array covers the viewport, or is centred when it is smaller.
double clampedAlong(double centre, double taxels, double visibleTaxels) {
    if (visibleTaxels >= taxels)
        return 0.5 * taxels;
    return std::clamp(centre, 0.5 * visibleTaxels, taxels - 0.5 * visibleTaxels);
}

} // namespace

HeatmapLayout::HeatmapLayout(const QRectF& bounds, const QFontMetricsF& metrics,
                             const core::ArrayLayout& array, const HeatmapZoom& zoom, double devicePixelRatio)
    : m_array(array) {
    const double em = metrics.height();
    const QRectF inner = bounds.adjusted(0.5 * em, 0.25 * em, -0.5 * em, -0.25 * em);
    m_header = QRectF(inner.left(), inner.top(), inner.width(), 1.8 * em);
    m_readout = QRectF(inner.left(), inner.bottom() - 1.4 * em, inner.width(), 1.4 * em);
    m_legend = m_readout.translated(0.0, -1.4 * em);

    const double axisLeft = metrics.horizontalAdvance(QStringLiteral("\u2212888")) + 1.2 * em;
    const double axisBottom = 2.3 * em;
    const double barWidth = 0.9 * em;
    const double barLabels = metrics.horizontalAdvance(QStringLiteral("8888.")) + 1.2 * em;
    m_viewport = QRectF(inner.left() + axisLeft, m_header.bottom() + 1.1 * em, 0.0, 0.0);
    m_viewport.setRight(std::max(m_viewport.left() + 1.0, inner.right() - barLabels - barWidth - em));
    m_viewport.setBottom(std::max(m_viewport.top() + 1.0, m_legend.top() - axisBottom));

    const double columns = array.columns;
    const double rows = array.rows;
    const double dpr = devicePixelRatio > 0.0 ? devicePixelRatio : 1.0;
    double fitted = std::min(m_viewport.width() / columns, m_viewport.height() / rows);
    if (fitted * dpr >= 2.0)
        fitted = std::floor(fitted * dpr) / dpr;
    m_side = fitted * std::max(1.0, zoom.factor);

    const auto snapped = [dpr](double v) { return std::round(v * dpr) / dpr; };
    const QPointF centre = clampedCentre(zoom.centre);
    const QSizeF size(columns * m_side, rows * m_side);
    const QPointF lowerLeft(m_viewport.center().x() - centre.x() * m_side,
                            m_viewport.center().y() + centre.y() * m_side);
    m_sensor = QRectF(QPointF(snapped(lowerLeft.x()), snapped(lowerLeft.y() - size.height())), size);
    m_visible = m_sensor.intersected(m_viewport);

    const double barHeight =
        std::clamp(m_visible.height(), std::min(7.0 * em, m_viewport.height()), 24.0 * em);
    m_colourBar =
        QRectF(m_visible.right() + em, m_visible.center().y() - 0.5 * barHeight, barWidth, barHeight);
    if (m_colourBar.top() < m_viewport.top())
        m_colourBar.moveTop(m_viewport.top());
}

QPointF HeatmapLayout::gridPoint(double column, double row) const {
    return {m_sensor.left() + column * m_side, m_sensor.bottom() - row * m_side};
}

QRectF HeatmapLayout::taxelRect(const Taxel& taxel) const {
    return {gridPoint(taxel.column, taxel.row + 1.0), QSizeF(m_side, m_side)};
}

QPointF HeatmapLayout::pixelOf(double x_m, double y_m) const {
    const double perMetre = m_side / m_array.pitch_m;
    return m_sensor.center() + QPointF(x_m * perMetre, -y_m * perMetre);
}

QPointF HeatmapLayout::gridAt(const QPointF& pixel) const {
    return {(pixel.x() - m_sensor.left()) / m_side, (m_sensor.bottom() - pixel.y()) / m_side};
}

std::optional<Taxel> HeatmapLayout::taxelAt(const QPointF& pixel) const {
    if (!m_visible.contains(pixel))
        return std::nullopt;
    const QPointF grid = gridAt(pixel);
    return Taxel{std::clamp(static_cast<int>(std::floor(grid.y())), 0, m_array.rows - 1),
                 std::clamp(static_cast<int>(std::floor(grid.x())), 0, m_array.columns - 1)};
}

QPointF HeatmapLayout::clampedCentre(const QPointF& centre) const {
    return {clampedAlong(centre.x(), m_array.columns, m_viewport.width() / m_side),
            clampedAlong(centre.y(), m_array.rows, m_viewport.height() / m_side)};
}

} // namespace teleta::tactile
