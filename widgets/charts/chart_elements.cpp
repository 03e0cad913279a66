// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_elements.h"

#include "widgets/base/badge.h"
#include "widgets/base/calm_range.h"
#include "widgets/base/tabular_text.h"

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
    QFont bold = m_font;
    bold.setBold(true);
    const QFontMetricsF metrics(m_font);
    const double em = metrics.height();
    double y = area.top();
    painter->setFont(bold);
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

void HeaderElement::setInk(const QFont& font, const QColor& text, const QColor& badge) {
    m_font = font;
    m_ink = text;
    m_badgeColour = badge;
}

void HeaderElement::draw(QCPPainter* painter) {
    QRectF area = rect();
    painter->setFont(m_font);
    if (!m_badge.isEmpty()) {
        const QSizeF size = base::badgeSize(m_font, m_badge);
        const QRectF box(QPointF(area.right() - size.width(), area.center().y() - 0.5 * size.height()), size);
        base::paintBadge(*painter, box, m_badge, m_badgeColour);
        area.setRight(box.left());
    }
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

double RoundTicker::getTickStep(const QCPRange& range) {
    m_step = m_fixedStep > 0.0 ? m_fixedStep : base::niceStep(range.size() / std::max(1, tickCount()));
    return m_step;
}

QString RoundTicker::getTickLabel(double tick, const QLocale& locale, QChar, int) {
    const double value = std::abs(tick) < 1e-6 * m_step ? 0.0 : tick;
    return locale.toString(value, 'g', 4).replace(u'-', QChar(0x2212)) + m_suffix;
}

} // namespace teleta::charts
