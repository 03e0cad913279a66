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
#include <vector>

namespace teleta::tactile {

namespace {

constexpr double kSign_em = 1.2; ///< width of a sign of the legend, to its text

struct LegendPlace {
    int line = 0;
    double left = 0.0;
};

/// Width of a sign and its text. font: that of the heatmap.
double widthOf(const QString& text, const QFont& font) {
    return kSign_em * QFontMetricsF(font).height() +
           base::tabularWidth(QFontMetricsF(base::sized(font, base::kSmallText)), text);
}

/// Puts items into lines, with gaps.
std::vector<LegendPlace> inLines(const std::vector<double>& widths, double room, double gap) {
    std::vector<LegendPlace> places;
    LegendPlace next;
    for (const double width : widths) {
        if (next.left > 0.0 && next.left + width > room)
            next = {next.line + 1, 0.0};
        places.push_back(next);
        next.left += width + gap;
    }
    return places;
}

/// Ends with dots where there is too little room.
void drawLine(QPainter& painter, const QRectF& room, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const bool fits = base::tabularWidth(metrics, text) <= room.width();
    base::drawTabularText(painter, room, Qt::AlignLeft | Qt::AlignVCenter,
                          fits ? text : metrics.elidedText(text, Qt::ElideRight, room.width()));
}

} // namespace

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
    const QFont huge = base::bold(base::sized(normal, base::kHugeText));
    const auto wide = [](const QString& text, const QFont& font) {
        return base::tabularWidth(QFontMetricsF(font), text);
    };
    struct Pair {
        QString name, value, widest;
    };
    std::vector<Pair> pairs;
    for (const FrameLoad& load : m_content->loads)
        pairs.push_back({load.name, load.value, {}});
    pairs.push_back({tr("force"), base::withUnit(m_content->forceText, m_content->unit()), {}});
    if (m_content->hasShear() && m_content->shows(Overlay::shear))
        pairs.push_back({tr("shear"), base::withUnit(m_content->shearText, m_content->unit()), {}});
    pairs.push_back({tr("contacts"), QString::number(m_content->contacts()), QStringLiteral("88")});
    static constexpr std::array kTypes{QT_TR_NOOP("none"), QT_TR_NOOP("point"), QT_TR_NOOP("edge")};
    // The features are of all loads together: those of several contacts have no type.
    const QString type = m_content->contacts() > 1 ? tr("several", "contacts")
                         : m_content->contacts() == 0
                             ? tr("none")
                             : tr(kTypes[static_cast<std::size_t>(snapshot.features.type)]);
    pairs.push_back({tr("type"), type, tr("point")});
    // No load is shown without the mark that it is extrapolated.
    const QString mark = m_content->extrapolated ? tr("extrapolated", "loads") : QString();
    const double markWidth = mark.isEmpty() ? 0.0 : wide(mark, normal) + 1.2 * m_em;
    const auto nameWidth = [&](const Pair& pair) { return wide(pair.name, normal) + 0.4 * m_em; };
    const auto valueWidth = [&](const Pair& pair, const QFont& font) {
        return std::max(wide(pair.value, font), wide(pair.widest, font));
    };
    // The first value is larger where all of them still fit.
    double all = markWidth + valueWidth(pairs.front(), huge) - valueWidth(pairs.front(), bold) - 1.2 * m_em;
    for (const Pair& pair : pairs)
        all += nameWidth(pair) + valueWidth(pair, bold) + 1.2 * m_em;
    const bool isLarge = all <= rect.width() && QFontMetricsF(huge).height() <= rect.height();

    double x = rect.left();
    QStringList shown;
    const auto piece = [&](const QString& text, const QFont& font, QPalette::ColorRole colour, double width) {
        m_painter->setFont(font);
        m_painter->setPen(m_palette.color(colour));
        base::drawTabularText(*m_painter, QRectF(x, rect.top(), width, rect.height()),
                              Qt::AlignLeft | Qt::AlignVCenter, text);
        x += width;
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Pair& pair = pairs[i];
        const bool isLoad = i < m_content->loads.size();
        const QFont& font = i == 0 && isLarge ? huge : bold;
        if (x + nameWidth(pair) + valueWidth(pair, font) <= rect.right() - (isLoad ? markWidth : 0.0)) {
            piece(pair.name, normal, QPalette::PlaceholderText, nameWidth(pair));
            piece(pair.value, font, QPalette::Text, valueWidth(pair, font) + 1.2 * m_em);
            shown << pair.name + QLatin1Char(' ') + pair.value;
        }
        if (i + 1 == m_content->loads.size() && !mark.isEmpty() && !shown.isEmpty()) {
            piece(mark, normal, QPalette::PlaceholderText, markWidth);
            shown << mark;
        }
    }
    m_painter->setFont(normal);
    m_headerText = shown.join(QStringLiteral(", "));
}

std::vector<HeatmapPainter::LegendItem> HeatmapPainter::legendOf(const HeatmapContent& content) {
    std::vector<LegendItem> items;
    if (content.shows(Overlay::centreOfPressure))
        items.push_back({Sign::cross, tr("centre of pressure")});
    if (content.shows(Overlay::centreOfContact))
        items.push_back({Sign::ring, tr("centre of contact")});
    if (content.shows(Overlay::principalAxis))
        items.push_back({Sign::axis, tr("axis %1\u00b0").arg(content.angleText)});
    if (content.hasShear() && content.shows(Overlay::shear))
        items.push_back({Sign::shear, tr("shear, a taxel's width is %1")
                                          .arg(base::withUnit(base::significantDigits(content.shearTop, 3),
                                                              content.unit()))});
    items.push_back(
        {Sign::threshold,
         tr("threshold %1")
             .arg(base::withUnit(base::threeDigits(content.snapshot.threshold_N).remove(base::kFigureSpace),
                                 content.unit()))});
    if (content.snapshot.features.dead > 0)
        items.push_back({Sign::dead, tr("dead %1").arg(content.snapshot.features.dead)});
    return items;
}

HeatmapLayout HeatmapPainter::layoutOf(const HeatmapContent& content, const QRectF& bounds, const QFont& font,
                                       double devicePixelRatio) {
    const QFontMetricsF metrics(font);
    std::vector<double> widths;
    for (const LegendItem& item : legendOf(content))
        widths.push_back(widthOf(item.text, font));
    const std::vector<LegendPlace> places =
        inLines(widths, HeatmapLayout::legendRoom(bounds, metrics), metrics.height());
    return {bounds, metrics, content.snapshot.layout, content.zoom, devicePixelRatio, places.back().line + 1};
}

void HeatmapPainter::paintLegend() {
    std::vector<LegendItem> items = legendOf(*m_content);
    if (!hasRoomForShear(*m_layout))
        std::erase_if(items, [](const LegendItem& item) { return item.sign == Sign::shear; });
    const QFont normal = m_painter->font();
    m_painter->setRenderHint(QPainter::Antialiasing);
    if (m_layout->isLegendBeside())
        paintLegendBeside(items);
    else
        paintLegendBelow(items);
    m_painter->setRenderHint(QPainter::Antialiasing, false);
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

void HeatmapPainter::paintLegendBelow(const std::vector<LegendItem>& items) {
    const QRectF& rect = m_layout->legend();
    std::vector<double> widths;
    for (const LegendItem& item : items)
        widths.push_back(widthOf(item.text, m_painter->font()));
    const std::vector<LegendPlace> places = inLines(widths, rect.width(), m_em);
    m_painter->setFont(base::sized(m_painter->font(), base::kSmallText));
    const double height = HeatmapLayout::kLegendLine_em * m_em;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const QRectF line(rect.left() + places[i].left, rect.top() + 0.1 * m_em + places[i].line * height,
                          rect.width() - places[i].left, height);
        if (line.bottom() > rect.bottom())
            return; // a low view
        paintSign(items[i].sign, QPointF(line.left() + 0.5 * m_em, line.center().y()));
        const QRectF room = line.adjusted(kSign_em * m_em, 0.0, 0.0, 0.0);
        drawLine(*m_painter, room, items[i].text);
    }
}

/// Each in a line of its own, and those that are longer in several.
void HeatmapPainter::paintLegendBeside(const std::vector<LegendItem>& items) {
    const QRectF& rect = m_layout->legend();
    m_painter->setFont(base::sized(m_painter->font(), base::kSmallText));
    const QFontMetricsF metrics(m_painter->font());
    const double left = rect.left() + kSign_em * m_em;
    const double width = rect.right() - left;
    double top = rect.top();
    for (const LegendItem& item : items) {
        const double height =
            metrics.boundingRect(QRectF(0.0, 0.0, width, rect.height()), Qt::TextWordWrap, item.text)
                .height();
        const double line = 1.4 * m_em;
        if (top + line + height - metrics.height() > rect.bottom() + 0.5)
            continue;
        const double middle = top + 0.5 * line;
        paintSign(item.sign, QPointF(rect.left() + 0.5 * m_em, middle));
        const QRectF room(left, middle - 0.5 * metrics.height(), width, height);
        if (height > metrics.height())
            m_painter->drawText(room, Qt::TextWordWrap, item.text);
        else
            base::drawTabularText(*m_painter, room, Qt::AlignLeft | Qt::AlignVCenter, item.text);
        top += line + height - metrics.height();
    }
}

/// Leaves the pen for the text behind it.
void HeatmapPainter::paintSign(Sign sign, const QPointF& middle) {
    const QColor ink = m_palette.color(QPalette::Text);
    const double radius = 0.3 * m_em;
    const QPointF half(0.5 * m_em, 0.0);
    m_painter->setPen(QPen(ink, std::max(1.5, 0.11 * m_em), Qt::SolidLine, Qt::RoundCap));
    m_painter->setBrush(Qt::NoBrush);
    switch (sign) {
    case Sign::cross:
        drawCross(*m_painter, middle, 0.8 * radius);
        break;
    case Sign::ring:
        m_painter->drawEllipse(middle, radius, radius);
        break;
    case Sign::axis:
        m_painter->drawLine(middle - half, middle + half);
        break;
    case Sign::shear:
        drawShearArrow(*m_painter, middle - half, middle + 0.8 * half, 0.35 * m_em);
        break;
    case Sign::threshold:
        m_painter->setPen(Qt::NoPen);
        m_painter->setBrush(ink);
        drawArrowHead(*m_painter, middle + 0.5 * half, {1.0, 0.0}, 0.5 * m_em);
        break;
    case Sign::dead: {
        const QRectF box(middle - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
        m_painter->setPen(QPen(ink, 1.0));
        m_painter->drawRect(box);
        drawHatch(*m_painter, box, 0.5 * radius);
        break;
    }
    }
    m_painter->setPen(ink);
}

void HeatmapPainter::paintReadout() {
    m_painter->setPen(m_palette.color(m_content->cursor ? QPalette::Text : QPalette::PlaceholderText));
    const QString text =
        m_content->cursor ? taxelText(*m_content, *m_content->cursor) : tr("Point at a taxel to read it.");
    if (m_layout->isLegendBeside())
        m_painter->drawText(m_layout->readout(), Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, text);
    else
        drawLine(*m_painter, m_layout->readout(), text); // all of it is in the tool tip
}

} // namespace teleta::tactile
