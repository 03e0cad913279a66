// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/tactile/heatmap_content.h"

#include <QFontMetricsF>
#include <QRectF>

#include <algorithm>

namespace teleta::tactile {

/// The cells that a heatmap of an array has room for: the array's own, or those of a grid around taxels that
/// stand on none, each as large as their usual spacing.
[[nodiscard]] core::ArrayLayout cellsOf(const core::TaxelLayout& taxels);

/// Layout of a heatmap in px, and the map between the sensor frame {s} and the picture. {s} is drawn as seen
/// from outside the skin: x to the right, y up, z towards the viewer; row 0 is at the bottom. Cells have the
/// shape of the array's; at zoom 1 their shorter side is a whole number of device pixels if these are five or
/// more.
class HeatmapLayout {
public:
    /// Height of a line of the legend below the array in em: heights of the font.
    static constexpr double kLegendLine_em = 1.2;

    /// legendLines: how many the legend needs below the array; it gets at most three tenths of the height.
    HeatmapLayout(const QRectF& bounds, const QFontMetricsF& metrics, const core::TaxelLayout& taxels,
                  const HeatmapZoom& zoom, double devicePixelRatio, int legendLines = 1);

    /// Width of a line of the legend below the array.
    [[nodiscard]] static double legendRoom(const QRectF& bounds, const QFontMetricsF& metrics);

    [[nodiscard]] const QRectF& header() const { return m_header; }
    /// Below the array; beside it where the array is narrow and so becomes larger.
    [[nodiscard]] const QRectF& legend() const { return m_legend; }
    [[nodiscard]] bool isLegendBeside() const { return m_isLegendBeside; }
    /// Right of a narrow array, on which labels of contacts would hide them; otherwise empty.
    [[nodiscard]] const QRectF& labels() const { return m_labels; }
    [[nodiscard]] const QRectF& readout() const { return m_readout; }
    [[nodiscard]] const QRectF& colourBar() const { return m_colourBar; }
    /// The array, including its parts outside the viewport.
    [[nodiscard]] const QRectF& sensor() const { return m_sensor; }
    /// The visible part of the array; everything on the array is clipped to it.
    [[nodiscard]] const QRectF& visible() const { return m_visible; }
    /// The shorter side of a cell.
    [[nodiscard]] double taxelSide() const { return std::min(m_cell.width(), m_cell.height()); }
    [[nodiscard]] double perMetre() const { return m_perMetre; }

    /// Upper left corner of a grid point: column 0..columns, row 0..rows from the bottom.
    [[nodiscard]] QPointF gridPoint(double column, double row) const;
    /// The cell of a taxel; of one that stands on no grid, the box around its disc.
    [[nodiscard]] QRectF taxelRect(const Taxel& taxel) const;
    /// Centre of taxel (row, column) of the array is at {s} (x_m(column), y_m(row)).
    [[nodiscard]] QPointF pixelOf(double x_m, double y_m) const;
    /// The taxel at a point of the visible part.
    [[nodiscard]] std::optional<Taxel> taxelAt(const QPointF& pixel) const;
    /// The same point in columns and rows, for panning and zooming.
    [[nodiscard]] QPointF gridAt(const QPointF& pixel) const;
    /// The centre nearest to the wanted one with which the array fills the viewport.
    [[nodiscard]] QPointF clampedCentre(const QPointF& centre) const;

private:
    core::TaxelLayout m_taxels;
    core::ArrayLayout m_array; ///< the cells
    QRectF m_header, m_legend, m_readout, m_colourBar, m_viewport, m_sensor, m_visible, m_labels;
    bool m_isLegendBeside = false;
    QSizeF m_cell{1.0, 1.0};
    double m_perMetre = 1.0; ///< px
};

} // namespace teleta::tactile
