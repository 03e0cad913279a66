// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/heatmap_ink.h"
#include "widgets/tactile/heatmap_painter.h"

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

void HeatmapPainter::paintScales() {
    constexpr double kMillimetres = 1e3;
    const QRectF& visible = m_layout->visible();
    const double pixelsPerMillimetre = m_layout->perMetre() / kMillimetres;
    const QColor ink = base::mixed(m_palette.color(QPalette::Text), m_palette.color(QPalette::Base), 0.25);
    const QFont normal = m_painter->font();
    const QFont small = base::sized(normal, base::kSmallText);
    const QFontMetricsF metrics(small);
    const double tick = 0.3 * m_em;
    const double left = visible.left() - 0.35 * m_em;
    const double bottom = visible.bottom() + 0.35 * m_em;

    m_painter->setFont(small);
    m_painter->setPen(QPen(ink, 1.0));
    const auto forTicks = [&](double low_mm, double high_mm, double spacing_px, auto&& draw) {
        const double step_mm = base::niceStep(spacing_px / pixelsPerMillimetre);
        const auto last = static_cast<int>(std::floor(high_mm / step_mm + 1e-6));
        for (auto i = static_cast<int>(std::ceil(low_mm / step_mm - 1e-6)); i <= last; ++i) {
            draw(i * step_mm / kMillimetres, base::significantDigits(i * step_mm, 4));
        }
    };
    const QPointF centre = m_layout->sensor().center();
    const auto millimetres = [&](double pixels) { return pixels / pixelsPerMillimetre; };

    forTicks(millimetres(visible.left() - centre.x()), millimetres(visible.right() - centre.x()), 3.2 * m_em,
             [&](double x_m, const QString& text) {
                 const double x = m_layout->pixelOf(x_m, 0.0).x();
                 m_painter->drawLine(QPointF(x, bottom), QPointF(x, bottom + tick));
                 m_painter->drawText(QRectF(x - 2.0 * m_em, bottom + tick, 4.0 * m_em, metrics.height()),
                                     Qt::AlignHCenter | Qt::AlignTop, text);
             });
    forTicks(millimetres(centre.y() - visible.bottom()), millimetres(centre.y() - visible.top()), 2.0 * m_em,
             [&](double y_m, const QString& text) {
                 const double y = m_layout->pixelOf(0.0, y_m).y();
                 m_painter->drawLine(QPointF(left - tick, y), QPointF(left, y));
                 m_painter->drawText(QRectF(left - tick - 5.0 * m_em, y - m_em, 4.8 * m_em, 2.0 * m_em),
                                     Qt::AlignRight | Qt::AlignVCenter, text);
             });

    m_painter->setRenderHint(QPainter::Antialiasing);
    m_painter->setBrush(ink);
    const QPointF xTip(visible.right() + 0.6 * m_em, bottom);
    const QPointF yTip(left, visible.top() - 0.6 * m_em);
    m_painter->drawLine(QPointF(left, bottom), xTip);
    m_painter->drawLine(QPointF(left, bottom), yTip);
    drawArrowHead(*m_painter, xTip, {1.0, 0.0}, 0.5 * m_em);
    drawArrowHead(*m_painter, yTip, {0.0, -1.0}, 0.5 * m_em);
    m_painter->setRenderHint(QPainter::Antialiasing, false);
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setPen(m_palette.color(QPalette::Text));
    m_painter->drawText(
        QRectF(xTip.x() - 4.0 * m_em, bottom + tick + metrics.height(), 4.3 * m_em, metrics.height()),
        Qt::AlignRight | Qt::AlignTop, base::titleWithUnit(tr("x"), QStringLiteral("mm")));
    m_painter->drawText(QRectF(yTip.x() - 5.3 * m_em, yTip.y() - 0.5 * m_em, 4.8 * m_em, metrics.height()),
                        Qt::AlignRight | Qt::AlignVCenter,
                        base::titleWithUnit(tr("y"), QStringLiteral("mm")));
    m_painter->setFont(normal);
}

void HeatmapPainter::paintColourBar() {
    const QRectF& bar = m_layout->colourBar();
    const base::ColourMap& map = base::cividis();
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    constexpr int kStops = 32;
    for (int i = 0; i <= kStops; ++i)
        gradient.setColorAt(static_cast<double>(i) / kStops,
                            QColor(base::colourAt(map, static_cast<double>(i) / kStops)));
    m_painter->fillRect(bar, gradient);
    const QColor ink = base::mixed(m_palette.color(QPalette::Text), m_palette.color(QPalette::Base), 0.25);
    m_painter->setPen(QPen(ink, 1.0));
    m_painter->setBrush(Qt::NoBrush);
    m_painter->drawRect(bar);

    const QFont normal = m_painter->font();
    const QFont small = base::sized(normal, base::kSmallText);
    m_painter->setFont(small);
    const QFontMetricsF metrics(small);
    const double top = m_content->rangeTop;
    const auto yOf = [&](double load) { return bar.bottom() - bar.height() * load / top; };
    const double step = base::niceStep(top * 2.0 * m_em / bar.height());
    const double right = bar.right() + 0.25 * m_em;
    const int ticks = static_cast<int>(std::floor(top / step + 1e-6));
    for (int i = 0; i <= ticks; ++i) {
        const double y = yOf(i * step);
        m_painter->setPen(QPen(ink, 1.0));
        m_painter->drawLine(QPointF(bar.right(), y), QPointF(right, y));
        m_painter->setPen(m_palette.color(QPalette::Text));
        m_painter->drawText(QPointF(right + 0.2 * m_em, y + 0.5 * (metrics.ascent() - metrics.descent())),
                            base::significantDigits(i * step, 4));
    }
    const QRectF unitRect(bar.left(), bar.top() - 1.15 * m_em, 6.0 * m_em, m_em);
    m_painter->drawText(unitRect, Qt::AlignLeft | Qt::AlignVCenter, m_content->unit());
    const QString mode = m_content->rangeFixed ? tr("fixed") : tr("auto");
    m_painter->setPen(m_palette.color(QPalette::PlaceholderText));
    m_painter->drawText(QRectF(bar.left(), bar.bottom() + 0.35 * m_em, 6.0 * m_em, m_em),
                        Qt::AlignLeft | Qt::AlignVCenter, mode);

    const double threshold = m_content->snapshot.threshold_N;
    m_painter->setRenderHint(QPainter::Antialiasing);
    if (threshold > 0.0 && threshold <= top) {
        const double y = yOf(threshold);
        m_painter->setPen(QPen(Qt::white, 1.5));
        m_painter->drawLine(QPointF(bar.left(), y), QPointF(bar.right(), y));
        m_painter->setPen(Qt::NoPen);
        m_painter->setBrush(m_palette.color(QPalette::Text));
        drawArrowHead(*m_painter, QPointF(bar.left() + 1.0, y), {1.0, 0.0}, 0.5 * m_em);
    }
    const auto& loads = m_content->snapshot.load_N;
    const bool over = std::ranges::any_of(
        loads, [top](float load) { return static_cast<double>(load) > top * (1.0 + 1e-6); });
    if (over) { // loads beyond a fixed range
        m_painter->setPen(QPen(ink, 1.0));
        m_painter->setBrush(QColor(map.back()));
        m_painter->drawPolygon(
            QPolygonF{bar.topLeft(), bar.topRight(), QPointF(bar.center().x(), bar.top() - 0.5 * m_em)});
    }
    m_painter->setRenderHint(QPainter::Antialiasing, false);
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

} // namespace teleta::tactile
