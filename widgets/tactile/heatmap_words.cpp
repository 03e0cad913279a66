// SPDX-License-Identifier: GPL-3.0-or-later
// The words around the array: header, legend, read-out.
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/heatmap_ink.h"
#include "widgets/tactile/heatmap_painter.h"
#include "widgets/tactile/shear_arrows.h"

#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <array>

namespace teleta::tactile {

/// Wider than an array that is narrow.
void HeatmapPainter::paintVeilText() {
    const QString text = tr("No new data: the last frame is shown.");
    QRectF room = m_layout->visible();
    const double missing = std::max(0.0, std::min(12.0 * m_em, m_layout->header().width()) - room.width());
    room.adjust(-0.5 * missing, 0.0, 0.5 * missing, 0.0);
    const QRectF words = QFontMetricsF(m_painter->font())
                             .boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text)
                             .adjusted(-0.4 * m_em, -0.2 * m_em, 0.4 * m_em, 0.2 * m_em);
    m_painter->fillRect(words, m_palette.color(QPalette::Window));
    m_painter->setPen(m_palette.color(QPalette::WindowText));
    m_painter->drawText(room, Qt::AlignCenter | Qt::TextWordWrap, text);
}

void HeatmapPainter::paintHeader() {
    const pipeline::TouchSnapshot& snapshot = m_content->snapshot;
    const QRectF rect =
        base::paintProvenance(*m_painter, m_layout->header(), m_content->provenance, m_palette, m_em);
    const QFont normal = m_painter->font();
    const QFont bold = base::bold(base::sized(normal, base::kLargeText));
    double x = rect.left();
    QStringList shown;
    const auto piece = [&](const QString& text, bool strong, double width) {
        m_painter->setFont(strong ? bold : normal);
        m_painter->setPen(m_palette.color(strong ? QPalette::Text : QPalette::PlaceholderText));
        base::drawTabularText(*m_painter, QRectF(x, rect.top(), width, rect.height()),
                              Qt::AlignLeft | Qt::AlignVCenter, text);
        x += width;
    };
    const auto widthOf = [&](const QString& text, bool strong) {
        return base::tabularWidth(QFontMetricsF(strong ? bold : normal), text);
    };
    double right = rect.right();
    const auto pair = [&](const QString& name, const QString& value, const QString& widest) {
        const double nameWidth = widthOf(name, false) + 0.4 * m_em;
        const double valueWidth = std::max(widthOf(value, true), widthOf(widest, true));
        if (x + nameWidth + valueWidth > right)
            return;
        piece(name, false, nameWidth);
        piece(value, true, valueWidth + 1.2 * m_em);
        shown << name + QLatin1Char(' ') + value;
    };
    // No load is shown without the mark that it is extrapolated.
    const QString mark = m_content->extrapolated ? tr("extrapolated", "loads") : QString();
    const double markWidth = mark.isEmpty() ? 0.0 : widthOf(mark, false) + 1.2 * m_em;
    right -= markWidth;
    for (const FrameLoad& load : m_content->loads)
        pair(load.name, load.value, {});
    right += markWidth;
    if (!mark.isEmpty() && !shown.isEmpty()) {
        piece(mark, false, markWidth);
        shown << mark;
    }
    pair(tr("force"), base::withUnit(m_content->forceText, m_content->unit()), {});
    if (m_content->hasShear() && m_content->shows(Overlay::shear))
        pair(tr("shear"), base::withUnit(m_content->shearText, m_content->unit()), {});
    pair(tr("contacts"), QString::number(m_content->contacts()), QStringLiteral("88"));
    static constexpr std::array kTypes{QT_TR_NOOP("none"), QT_TR_NOOP("point"), QT_TR_NOOP("edge")};
    pair(tr("type"), tr(kTypes[static_cast<std::size_t>(snapshot.features.type)]), {});
    m_painter->setFont(normal);
    m_headerText = shown.join(QStringLiteral(", "));
}

void HeatmapPainter::paintLegend() {
    const pipeline::TouchSnapshot& snapshot = m_content->snapshot;
    const QRectF& rect = m_layout->legend();
    const QColor ink = m_palette.color(QPalette::Text);
    const QFont normal = m_painter->font();
    m_painter->setFont(base::sized(normal, base::kSmallText));
    const QFontMetricsF metrics(m_painter->font());
    m_painter->setRenderHint(QPainter::Antialiasing);
    QRectF line = rect;
    line.setHeight(std::min(rect.height(), 1.4 * m_em));
    const double radius = 0.3 * m_em;
    const auto item = [&](const QString& text, auto&& symbol) {
        const double textLeft = line.left() + 1.2 * m_em;
        double width = 1.2 * m_em + base::tabularWidth(metrics, text) + m_em;
        double lower = 0.0; // where a text goes on below its line
        if (line.left() + width > rect.right() + m_em && m_layout->isLegendBeside()) {
            const QRectF room(0.0, 0.0, rect.right() - textLeft, rect.height());
            lower = metrics.boundingRect(room, Qt::TextWordWrap, text).height() - metrics.height();
            width = rect.right() - line.left() + m_em;
        }
        if (line.left() + width > rect.right() + m_em || line.bottom() + lower > rect.bottom() + 0.5)
            return;
        m_painter->setPen(QPen(ink, std::max(1.5, 0.11 * m_em), Qt::SolidLine, Qt::RoundCap));
        m_painter->setBrush(Qt::NoBrush);
        symbol(QPointF(line.left() + 0.5 * m_em, line.center().y()));
        m_painter->setPen(ink);
        if (lower > 0.0)
            m_painter->drawText(QRectF(textLeft, line.center().y() - 0.5 * metrics.height(),
                                       rect.right() - textLeft, metrics.height() + lower),
                                Qt::TextWordWrap, text);
        else
            base::drawTabularText(*m_painter, QRectF(textLeft, line.top(), width, line.height()),
                                  Qt::AlignLeft | Qt::AlignVCenter, text);
        if (m_layout->isLegendBeside())
            line.translate(0.0, line.height() + lower);
        else
            line.setLeft(line.left() + width);
    };
    if (m_content->shows(Overlay::centreOfPressure))
        item(tr("centre of pressure"), [&](const QPointF& p) { drawCross(*m_painter, p, 0.8 * radius); });
    if (m_content->shows(Overlay::centreOfContact))
        item(tr("centre of contact"), [&](const QPointF& p) { m_painter->drawEllipse(p, radius, radius); });
    if (m_content->shows(Overlay::principalAxis))
        item(tr("axis %1\u00b0").arg(m_content->angleText), [&](const QPointF& p) {
            m_painter->drawLine(p - QPointF(0.5 * m_em, 0.0), p + QPointF(0.5 * m_em, 0.0));
        });
    if (m_content->hasShear() && m_content->shows(Overlay::shear) && hasRoomForShear(*m_layout))
        item(tr("shear, a taxel's width is %1")
                 .arg(base::withUnit(base::significantDigits(m_content->shearTop, 3), m_content->unit())),
             [&](const QPointF& p) {
                 drawShearArrow(*m_painter, p - QPointF(0.5 * m_em, 0.0), p + QPointF(0.4 * m_em, 0.0),
                                0.35 * m_em);
             });
    item(tr("threshold %1")
             .arg(base::withUnit(base::threeDigits(snapshot.threshold_N).remove(QChar(0x2007)),
                                 m_content->unit())),
         [&](const QPointF& p) {
             m_painter->setPen(Qt::NoPen);
             m_painter->setBrush(m_palette.color(QPalette::Text));
             drawArrowHead(*m_painter, p + QPointF(0.25 * m_em, 0.0), {1.0, 0.0}, 0.5 * m_em);
         });
    if (snapshot.features.dead > 0)
        item(tr("dead %1").arg(snapshot.features.dead), [&](const QPointF& p) {
            const QRectF box(p - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
            m_painter->setPen(QPen(ink, 1.0));
            m_painter->drawRect(box);
            drawHatch(*m_painter, box, 0.5 * radius);
        });
    m_painter->setRenderHint(QPainter::Antialiasing, false);

    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

void HeatmapPainter::paintReadout() {
    m_painter->setPen(m_palette.color(m_content->cursor ? QPalette::Text : QPalette::PlaceholderText));
    const QString text =
        m_content->cursor ? taxelText(*m_content, *m_content->cursor) : tr("Point at a taxel to read it.");
    if (m_layout->isLegendBeside())
        m_painter->drawText(m_layout->readout(), Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, text);
    else
        base::drawTabularText(*m_painter, m_layout->readout(), Qt::AlignLeft | Qt::AlignVCenter, text);
}

} // namespace teleta::tactile
