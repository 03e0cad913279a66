// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/tactile/heatmap_content.h"
#include "widgets/tactile/heatmap_layout.h"
#include "widgets/tactile/place_discs.h"

#include <QCoreApplication>
#include <QFont>
#include <QImage>
#include <QPainterPath>
#include <QPalette>

#include <vector>

class QPainter;

namespace teleta::tactile {

/// Draws a heatmap on a screen or on paper. Thread: GUI.
class HeatmapPainter {
    Q_DECLARE_TR_FUNCTIONS(HeatmapPainter)

public:
    enum class Medium {
        screen, ///< taxels of a grid as one image
        paper,  ///< taxels as rectangles, sharp at any scale
    };

    /// Lays content out: the legend has as many lines as its texts need.
    [[nodiscard]] static HeatmapLayout layoutOf(const HeatmapContent& content, const QRectF& bounds,
                                                const QFont& font, double devicePixelRatio);

    /// Draws content as laid out, with the painter's font and the colours of the palette.
    void paint(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content,
               const QPalette& palette, Medium medium);

    /// What the header said when it was last painted: "load 1.250 ± 0.050 N, contacts 2".
    [[nodiscard]] const QString& headerText() const { return m_headerText; }

private:
    enum class Sign { cross, ring, axis, shear, threshold, dead };
    struct LegendItem {
        Sign sign = Sign::cross;
        QString text;
    };

    [[nodiscard]] static std::vector<LegendItem> legendOf(const HeatmapContent& content);
    void paintTaxels(Medium medium);
    void paintAbsent();
    void paintDead();
    void paintGrid();
    void paintValues();
    void paintContacts();
    void paintContactLabels();
    void paintLabelsBeside();
    void paintChip(const QRectF& chip, int id, const QString& text);
    void paintAxis();
    void paintMarks();
    void paintCursor();
    void paintVeil();
    void paintVeilText();
    void paintScales();
    void paintColourBar();
    void paintHeader();
    void paintLegend();
    void paintLegendBelow(const std::vector<LegendItem>& items);
    void paintLegendBeside(const std::vector<LegendItem>& items);
    void paintSign(Sign sign, const QPointF& middle);
    void paintReadout();
    [[nodiscard]] double markRadius() const;
    [[nodiscard]] DiscEnds endsOf(const contact::Contact& contact) const;
    [[nodiscard]] int firstColumn(const contact::Contact& contact, int row) const;

    QPainter* m_painter = nullptr;
    const HeatmapLayout* m_layout = nullptr;
    const HeatmapContent* m_content = nullptr;
    QPalette m_palette;
    double m_em = 16.0;
    QString m_headerText;
    QImage m_image; ///< reused to avoid allocations
};

} // namespace teleta::tactile
