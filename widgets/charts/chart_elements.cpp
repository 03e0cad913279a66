// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_elements.h"

#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>

#include <cmath>

namespace teleta::charts {

void ValuePanel::setInk(const QFont& font, const QColor& text, const QColor& faint) {
    m_font = font;
    m_text = text;
    m_faint = faint;
}

void ValuePanel::draw(QCPPainter* painter) {
    const QRectF area = rect();
    const QFontMetricsF metrics(m_font);
    const double em = metrics.height();
    double y = area.top();
    painter->setFont(base::bold(m_font));
    painter->setPen(m_text);
    painter->drawText(QRectF(area.left(), y, area.width(), em), Qt::AlignLeft | Qt::AlignVCenter, m_title);
    y += 1.15 * em;
    painter->setFont(m_font);
    for (const Line& line : m_lines) {
        const QRectF row(area.left(), y, area.width(), em);
        painter->setAntialiasing(false);
        painter->setPen(QPen(line.colour, std::max(2.0, 0.15 * em), line.dashed ? Qt::DotLine : Qt::SolidLine,
                             Qt::FlatCap));
        painter->drawLine(QLineF(row.left(), row.center().y(), row.left() + 0.9 * em, row.center().y()));
        painter->setPen(m_faint);
        painter->drawText(row.adjusted(1.2 * em, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, line.name);
        painter->setPen(m_text);
        base::drawTabularText(*painter, row, Qt::AlignRight | Qt::AlignVCenter, line.value);
        y += 1.1 * em;
    }
}

void HeaderElement::setInk(const QFont& font, const QColor& text, const QPalette& palette) {
    m_font = font;
    m_ink = text;
    m_palette = palette;
}

void HeaderElement::draw(QCPPainter* painter) {
    painter->setFont(m_font);
    const QRectF area = base::paintProvenance(*painter, rect(), m_provenance, m_palette, 0.0);
    painter->setPen(m_ink);
    base::drawTabularText(*painter, area, Qt::AlignLeft | Qt::AlignVCenter, m_text);
}

TimeLines::TimeLines(QCustomPlot* plot, const QString& layer)
    : QCPLayerable(plot, layer) {
}

void TimeLines::draw(QCPPainter* painter) {
    painter->setAntialiasing(false);
    painter->setFont(m_font);
    const QFontMetricsF metrics(m_font);
    for (const TimeLine& line : m_lines) {
        bool first = true;
        for (QCPAxisRect* rect : m_rects) {
            const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
            if (!axis->range().contains(line.time_s))
                continue;
            const double x = std::round(axis->coordToPixel(line.time_s));
            painter->setPen(m_pen);
            painter->drawLine(QLineF(x, rect->top(), x, rect->bottom()));
            if (first && !line.label.isEmpty()) {
                const double width = metrics.horizontalAdvance(line.label) + 0.6 * metrics.height();
                const bool flip = x + width > rect->right();
                const QRectF box(flip ? x - width : x, rect->top(), width, 1.1 * metrics.height());
                painter->fillRect(box, m_pen.color());
                painter->setPen(QPen(qGray(m_pen.color().rgb()) > 140 ? Qt::black : Qt::white));
                painter->drawText(box, Qt::AlignCenter, line.label);
            }
            first = false;
        }
    }
}

Shades::Shades(QCustomPlot* plot, const QString& layer, Kind kind)
    : QCPLayerable(plot, layer)
    , m_kind(kind) {
}

void Shades::setInk(const QFont& font, const QColor& fill, const QPen& edge, const QColor& text) {
    m_font = font;
    m_fill = fill;
    m_edge = edge;
    m_text = text;
}

void Shades::draw(QCPPainter* painter) {
    painter->setAntialiasing(false);
    painter->setFont(m_font);
    for (const Shade& shade : m_shades) {
        for (const QCPAxisRect* rect : m_rects) {
            const bool times = m_kind == Kind::times;
            const QCPAxis* axis = rect->axis(times ? QCPAxis::atBottom : QCPAxis::atLeft);
            // Clipped here and not by the painter, because SVG pictures have no clipping.
            const double from = std::max(shade.from, axis->range().lower);
            const double to = std::min(shade.to, axis->range().upper);
            if (!(from < to))
                continue;
            const double a = axis->coordToPixel(from), b = axis->coordToPixel(to);
            const QRectF area = times ? QRectF(a, rect->top(), b - a, rect->height())
                                      : QRectF(rect->left(), b, rect->width(), a - b);
            painter->fillRect(area, m_fill);
            painter->setPen(m_edge);
            for (const double end : {shade.from, shade.to}) {
                if (!axis->range().contains(end))
                    continue;
                const double at = std::round(axis->coordToPixel(end));
                painter->drawLine(times ? QLineF(at, area.top(), at, area.bottom())
                                        : QLineF(area.left(), at, area.right(), at));
            }
            if (times && rect == m_rects.front() && !shade.label.isEmpty()) {
                const QFontMetricsF metrics(m_font);
                const double width = metrics.horizontalAdvance(shade.label);
                const double left = std::min(area.left() + 0.25 * metrics.height(), rect->right() - width);
                painter->setPen(m_text);
                painter->drawText(QRectF(left, area.top(), width + 1.0, metrics.height()),
                                  Qt::AlignLeft | Qt::AlignVCenter, shade.label);
            }
        }
    }
}

void styleAxes(QCPAxisRect* rect, const QFont& font, const QPalette& palette) {
    const double em = QFontMetricsF(font).height();
    const QColor text = palette.color(QPalette::Text);
    const QColor ground = palette.color(QPalette::Base);
    const QColor faint = base::mixed(text, ground, 0.35);
    const QPen gridPen(base::mixed(text, ground, 0.88), 1.0);
    const QFont small = base::sized(font, base::kSmallText);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
        QCPAxis* axis = rect->axis(side);
        axis->setBasePen(QPen(faint, 1.0));
        axis->setTickPen(QPen(faint, 1.0));
        axis->setTickLabelColor(text);
        axis->setTickLabelFont(small);
        axis->setLabelColor(faint);
        axis->setLabelFont(small);
        axis->setTickLengthIn(0);
        axis->setTickLengthOut(static_cast<int>(0.2 * em));
        axis->setTickLabelPadding(static_cast<int>(0.2 * em));
        axis->grid()->setPen(gridPen);
    }
    rect->axis(QCPAxis::atLeft)->grid()->setZeroLinePen(QPen(base::mixed(text, ground, 0.65), 1.0));
}

double RoundTicker::getTickStep(const QCPRange& range) {
    m_step = m_fixedStep > 0.0 ? m_fixedStep : base::niceStep(range.size() / std::max(1, tickCount()));
    // Where a fixed step would give more labels than there is room for, every second one, or fewer.
    while (range.size() > (tickCount() + 1.5) * m_step)
        m_step *= 2.0;
    return m_step;
}

QString RoundTicker::getTickLabel(double tick, const QLocale& locale, QChar, int) {
    const double value = std::abs(tick) < 1e-6 * m_step ? 0.0 : tick;
    return locale.toString(value, 'g', 4).replace(u'-', QChar(0x2212)) + m_suffix;
}

} // namespace teleta::charts
