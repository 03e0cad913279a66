// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_layout.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

namespace {

constexpr double kAside_em = 0.5; ///< left and right of everything
constexpr double kHeader_em = 1.8;
constexpr double kTallHeader_em = 2.6; ///< where there is room for a large reading
constexpr double kTall_em = 24.0;
constexpr double kMostLegend = 0.3; ///< of the height, below the array
constexpr double kBeside_em = 9.5;  ///< width of a legend beside the array
constexpr double kLabels_em = 2.5;  ///< width of the labels of contacts beside it
constexpr double kNarrow_em = 8.0;  ///< width of an array on which labels would hide its contacts
constexpr double kGain = 1.1;       ///< of the size of its taxels, from which the legend goes beside it

/// Device pixels of a taxel from which it is a whole number of them: of smaller ones, too much room would be
/// lost.
constexpr double kWholePixels = 5.0;

/// Centre along one axis so that the array covers the viewport, or is centred when it is smaller.
double clampedAlong(double centre, double taxels, double visibleTaxels) {
    if (visibleTaxels >= taxels)
        return 0.5 * taxels;
    return std::clamp(centre, 0.5 * visibleTaxels, taxels - 0.5 * visibleTaxels);
}

} // namespace

core::ArrayLayout cellsOf(const core::TaxelLayout& taxels) {
    if (taxels.isGrid())
        return taxels.grid();
    const core::TaxelPlaces& places = *taxels.places();
    double x_m = 0.0;
    double y_m = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        x_m = std::max(x_m, std::abs(places[i].x_m) + 0.5 * places.spacing_m(i));
        y_m = std::max(y_m, std::abs(places[i].y_m) + 0.5 * places.spacing_m(i));
    }
    // Few taxels that are far apart are not to make more cells than an array may have.
    constexpr double kMost = core::ArrayLayout::kMaximumSide;
    const double pitch_m = std::max(places.pitch_m(), 2.0 * std::max(x_m, y_m) / kMost);
    const auto cells = [&](double half_m) {
        return std::max(1, static_cast<int>(std::min(kMost, std::ceil(2.0 * half_m / pitch_m - 1e-9))));
    };
    return {cells(y_m), cells(x_m), pitch_m};
}

double HeatmapLayout::legendRoom(const QRectF& bounds, const QFontMetricsF& metrics) {
    return bounds.width() - 2.0 * kAside_em * metrics.height();
}

HeatmapLayout::HeatmapLayout(const QRectF& bounds, const QFontMetricsF& metrics,
                             const core::TaxelLayout& taxels, const HeatmapZoom& zoom,
                             double devicePixelRatio, int legendLines)
    : m_taxels(taxels)
    , m_array(cellsOf(taxels)) {
    const double em = metrics.height();
    const QRectF inner = bounds.adjusted(kAside_em * em, 0.25 * em, -kAside_em * em, -0.25 * em);
    m_header = QRectF(inner.left(), inner.top(), inner.width(),
                      (inner.height() >= kTall_em * em ? kTallHeader_em : kHeader_em) * em);
    m_readout = QRectF(inner.left(), inner.bottom() - 1.4 * em, inner.width(), 1.4 * em);
    const double line = kLegendLine_em * em;
    const double lines = std::clamp(std::floor(kMostLegend * inner.height() / line), 1.0,
                                    static_cast<double>(std::max(1, legendLines)));
    m_legend = m_readout;
    m_legend.setTop(m_readout.top() - 0.2 * em - lines * line);
    m_legend.setBottom(m_readout.top());

    const double axisLeft = metrics.horizontalAdvance(QStringLiteral("\u2212888")) + 1.2 * em;
    const double axisBottom = 2.3 * em;
    const double barWidth = 0.9 * em;
    const double barLabels = metrics.horizontalAdvance(QStringLiteral("8888.")) + 1.2 * em;
    m_viewport = QRectF(inner.left() + axisLeft, m_header.bottom() + 1.1 * em, 0.0, 0.0);
    m_viewport.setRight(std::max(m_viewport.left() + 1.0, inner.right() - barLabels - barWidth - em));
    m_viewport.setBottom(std::max(m_viewport.top() + 1.0, m_legend.top() - axisBottom));
    const double besideAt = inner.right() - kBeside_em * em;
    const double besideRight = besideAt - barLabels - barWidth - (1.0 + kLabels_em) * em;
    const double besideBottom = inner.bottom() - axisBottom;

    const double columns = m_array.columns;
    const double rows = m_array.rows;
    const double dpr = devicePixelRatio > 0.0 ? devicePixelRatio : 1.0;
    const double shorter_m = std::min(m_array.pitchX_m, m_array.pitchY_m);
    const double width = m_array.pitchX_m / shorter_m;
    const double height = m_array.pitchY_m / shorter_m;
    const auto fit = [&](const QRectF& room) {
        return std::min(room.width() / (columns * width), room.height() / (rows * height));
    };
    QRectF beside = m_viewport;
    beside.setRight(std::max(beside.left() + 1.0, besideRight));
    beside.setBottom(std::max(beside.top() + 1.0, besideBottom));
    m_isLegendBeside = fit(beside) > kGain * fit(m_viewport);
    if (m_isLegendBeside) {
        m_viewport = beside;
        const double middle = m_header.bottom() + 0.5 * (inner.bottom() - m_header.bottom());
        m_legend = QRectF(QPointF(besideAt, m_header.bottom()), QPointF(inner.right(), middle));
        m_readout = QRectF(QPointF(besideAt, middle), inner.bottomRight());
    }
    double fitted = fit(m_viewport);
    if (fitted * dpr >= kWholePixels)
        fitted = std::floor(fitted * dpr) / dpr;
    fitted *= std::max(1.0, zoom.factor);
    m_cell = {fitted * width, fitted * height};
    m_perMetre = fitted / shorter_m;

    const auto snapped = [dpr](double v) { return std::round(v * dpr) / dpr; };
    const QPointF centre = clampedCentre(zoom.centre);
    const QSizeF size(columns * m_cell.width(), rows * m_cell.height());
    const QPointF lowerLeft(m_viewport.center().x() - centre.x() * m_cell.width(),
                            m_viewport.center().y() + centre.y() * m_cell.height());
    m_sensor = QRectF(QPointF(snapped(lowerLeft.x()), snapped(lowerLeft.y() - size.height())), size);
    m_visible = m_sensor.intersected(m_viewport);

    const double barHeight =
        std::clamp(m_visible.height(), std::min(7.0 * em, m_viewport.height()), 24.0 * em);
    if (m_isLegendBeside && m_visible.width() < kNarrow_em * em)
        m_labels = QRectF(m_visible.right() + 0.5 * em, m_visible.top(), kLabels_em * em, m_visible.height());
    m_colourBar = QRectF(m_visible.right() + m_labels.width() + em, m_visible.center().y() - 0.5 * barHeight,
                         barWidth, barHeight);
    if (m_colourBar.top() < m_viewport.top())
        m_colourBar.moveTop(m_viewport.top());
}

QPointF HeatmapLayout::gridPoint(double column, double row) const {
    return {m_sensor.left() + column * m_cell.width(), m_sensor.bottom() - row * m_cell.height()};
}

QRectF HeatmapLayout::taxelRect(const Taxel& taxel) const {
    if (m_taxels.isGrid())
        return {gridPoint(taxel.column, taxel.row + 1.0), m_cell};
    const core::TaxelPlaces& places = *m_taxels.places();
    const auto index = static_cast<std::size_t>(taxel.column);
    const double radius = 0.5 * m_perMetre * places.spacing_m(index);
    const QPointF centre = pixelOf(places[index].x_m, places[index].y_m);
    return QRectF(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
}

QPointF HeatmapLayout::pixelOf(double x_m, double y_m) const {
    return m_sensor.center() + QPointF(x_m * m_perMetre, -y_m * m_perMetre);
}

QPointF HeatmapLayout::gridAt(const QPointF& pixel) const {
    return {(pixel.x() - m_sensor.left()) / m_cell.width(),
            (m_sensor.bottom() - pixel.y()) / m_cell.height()};
}

std::optional<Taxel> HeatmapLayout::taxelAt(const QPointF& pixel) const {
    if (!m_visible.contains(pixel))
        return std::nullopt;
    if (!m_taxels.isGrid()) {
        for (int taxel = 0; taxel < m_taxels.grid().columns; ++taxel) {
            const QRectF disc = taxelRect({0, taxel});
            if (QLineF(disc.center(), pixel).length() <= 0.5 * disc.width())
                return Taxel{0, taxel};
        }
        return std::nullopt;
    }
    const QPointF grid = gridAt(pixel);
    return Taxel{std::clamp(static_cast<int>(std::floor(grid.y())), 0, m_array.rows - 1),
                 std::clamp(static_cast<int>(std::floor(grid.x())), 0, m_array.columns - 1)};
}

QPointF HeatmapLayout::clampedCentre(const QPointF& centre) const {
    return {clampedAlong(centre.x(), m_array.columns, m_viewport.width() / m_cell.width()),
            clampedAlong(centre.y(), m_array.rows, m_viewport.height() / m_cell.height())};
}

} // namespace teleta::tactile
