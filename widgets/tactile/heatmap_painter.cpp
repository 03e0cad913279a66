// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_painter.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/contact_outline.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace teleta::tactile {

namespace {

const QColor kDeadGround(0xff, 0xff, 0xff, 0x48);
const QColor kDeadHatch(0xe8, 0xe8, 0xe8);
const QColor kCasing(0x00, 0x00, 0x00, 0xb0); ///< around marks, visible on yellow and on blue
const QColor kMark(0xff, 0xff, 0xff);

double shareOf(float load, double top) {
    return top > 0.0 ? static_cast<double>(load) / top : 0.0;
}

/// Draws a shape twice: wide and dark, then narrow and in its colour.
void cased(QPainter& painter, const QColor& colour, double width, const std::function<void()>& draw) {
    QPen pen(kCasing, width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(pen);
    draw();
    pen.setColor(colour);
    pen.setWidthF(width);
    painter.setPen(pen);
    draw();
}

void drawCross(QPainter& painter, const QPointF& centre, double radius) {
    painter.drawLine(centre + QPointF(-radius, -radius), centre + QPointF(radius, radius));
    painter.drawLine(centre + QPointF(-radius, radius), centre + QPointF(radius, -radius));
}

/// Clips a line to a rectangle, because SVG pictures have no clipping.
std::optional<QLineF> cutToRect(const QLineF& line, const QRectF& rect) {
    double first = 0.0, last = 1.0;
    const auto cut = [&](double start, double step, double low, double high) {
        if (step == 0.0) {
            if (start < low || start > high)
                last = -1.0;
            return;
        }
        const double a = (low - start) / step, b = (high - start) / step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    };
    cut(line.x1(), line.dx(), rect.left(), rect.right());
    cut(line.y1(), line.dy(), rect.top(), rect.bottom());
    if (first > last)
        return std::nullopt;
    return QLineF(line.pointAt(first), line.pointAt(last));
}

void drawHatch(QPainter& painter, const QRectF& rect, double spacing) {
    for (double offset = 0.5 * spacing; offset < rect.width() + rect.height(); offset += spacing) {
        const double x0 = std::max(0.0, offset - rect.height());
        const double x1 = std::min(offset, rect.width());
        painter.drawLine(QPointF(rect.left() + x0, rect.top() + offset - x0),
                         QPointF(rect.left() + x1, rect.top() + offset - x1));
    }
}

void drawArrowHead(QPainter& painter, const QPointF& tip, const QPointF& direction, double size) {
    const QPointF side(-direction.y(), direction.x());
    painter.drawPolygon(QPolygonF{tip, tip - direction * size + side * (0.4 * size),
                                  tip - direction * size - side * (0.4 * size)});
}

} // namespace

void HeatmapPainter::paint(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content,
                           const QPalette& palette, Medium medium) {
    m_painter = &painter;
    m_layout = &layout;
    m_content = &content;
    m_palette = palette;
    m_em = QFontMetricsF(painter.font()).height();
    painter.save();
    paintScales();
    painter.save();
    painter.setClipRect(layout.visible());
    paintTaxels(medium);
    paintGrid();
    paintDead();
    if (content.shows(Overlay::values))
        paintValues();
    painter.setRenderHint(QPainter::Antialiasing);
    if (content.shows(Overlay::contacts))
        paintContacts();
    if (content.shows(Overlay::principalAxis))
        paintAxis();
    paintMarks();
    if (content.shows(Overlay::contacts))
        paintContactLabels();
    paintCursor();
    if (content.old)
        paintVeil();
    painter.restore();
    paintColourBar();
    if (content.old)
        paintVeilText();
    paintHeader();
    paintLegend();
    if (medium == Medium::screen)
        paintReadout();
    painter.restore();
}

void HeatmapPainter::paintVeil() {
    constexpr int kVeil = 190; // of 255
    const QRectF all = m_layout->visible();
    QColor veil = m_palette.color(QPalette::Window);
    veil.setAlpha(kVeil);
    m_painter->fillRect(all, veil);
}

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

double HeatmapPainter::markRadius() const {
    return std::clamp(0.32 * m_layout->taxelSide(), 0.3 * m_em, 0.6 * m_em);
}

void HeatmapPainter::paintTaxels(Medium medium) {
    const core::ArrayLayout& array = m_content->snapshot.layout;
    const base::ColourMap& map = base::cividis();
    const std::vector<float>& loads = m_content->snapshot.load_N;
    if (medium == Medium::paper) {
        m_painter->setPen(Qt::NoPen);
        for (int row = 0; row < array.rows; ++row)
            for (int column = 0; column < array.columns; ++column) {
                const float load = loads[m_content->index({row, column})];
                m_painter->setBrush(QColor(base::colourAt(map, shareOf(load, m_content->rangeTop))));
                m_painter->drawRect(m_layout->taxelRect({row, column}));
            }
        m_painter->setBrush(Qt::NoBrush);
        return;
    }
    if (m_image.size() != QSize(array.columns, array.rows))
        m_image = QImage(array.columns, array.rows, QImage::Format_RGB32);
    for (int row = 0; row < array.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(m_image.scanLine(array.rows - 1 - row));
        const std::size_t first = m_content->index({row, 0});
        for (int column = 0; column < array.columns; ++column)
            line[column] = base::colourAt(
                map, shareOf(loads[first + static_cast<std::size_t>(column)], m_content->rangeTop));
    }
    m_painter->drawImage(m_layout->sensor(), m_image);
}

void HeatmapPainter::paintGrid() {
    constexpr double kSmallestSide = 9.0;
    if (m_layout->taxelSide() < kSmallestSide)
        return;
    const core::ArrayLayout& array = m_content->snapshot.layout;
    m_painter->setPen(QPen(QColor(0, 0, 0, 70), 1.0));
    const QRectF& sensor = m_layout->sensor();
    for (int column = 1; column < array.columns; ++column) {
        const double x = m_layout->gridPoint(column, 0.0).x();
        m_painter->drawLine(QPointF(x, sensor.top()), QPointF(x, sensor.bottom()));
    }
    for (int row = 1; row < array.rows; ++row) {
        const double y = m_layout->gridPoint(0.0, row).y();
        m_painter->drawLine(QPointF(sensor.left(), y), QPointF(sensor.right(), y));
    }
}

void HeatmapPainter::paintDead() {
    if (m_content->snapshot.dead.empty())
        return;
    const core::ArrayLayout& array = m_content->snapshot.layout;
    const double spacing = std::max(3.0, m_layout->taxelSide() / 3.0);
    m_painter->setRenderHint(QPainter::Antialiasing);
    for (int row = 0; row < array.rows; ++row)
        for (int column = 0; column < array.columns; ++column) {
            if (!m_content->isDead(m_content->index({row, column})))
                continue;
            const QRectF rect = m_layout->taxelRect({row, column});
            m_painter->fillRect(rect, kDeadGround);
            m_painter->setPen(QPen(kDeadHatch, std::max(1.0, 0.09 * m_em)));
            drawHatch(*m_painter, rect, spacing);
        }
    m_painter->setRenderHint(QPainter::Antialiasing, false);
}

void HeatmapPainter::paintValues() {
    const QFont normal = m_painter->font();
    const QFont small = base::sized(normal, base::kSmallText);
    const QFontMetricsF metrics(small);
    const double side = m_layout->taxelSide();
    if (metrics.horizontalAdvance(QStringLiteral("8.88")) + 4.0 > side || metrics.height() > side)
        return;
    m_painter->setFont(small);
    const core::ArrayLayout& array = m_content->snapshot.layout;
    for (int row = 0; row < array.rows; ++row)
        for (int column = 0; column < array.columns; ++column) {
            const Taxel taxel{row, column};
            const QRectF rect = m_layout->taxelRect(taxel);
            const std::size_t i = m_content->index(taxel);
            if (m_content->isDead(i) || !rect.intersects(m_layout->visible()))
                continue;
            const float load = m_content->snapshot.load_N[i];
            QColor colour =
                base::readableOn(QColor(base::colourAt(base::cividis(), shareOf(load, m_content->rangeTop))));
            if (static_cast<double>(load) < m_content->snapshot.threshold_N)
                colour.setAlphaF(0.55F);
            m_painter->setPen(colour);
            m_painter->drawText(rect, Qt::AlignCenter,
                                base::threeDigits(static_cast<double>(load)).remove(QChar(0x2007)));
        }
    m_painter->setFont(normal);
}

void HeatmapPainter::paintContacts() {
    const pipeline::TouchSnapshot& snapshot = m_content->snapshot;
    if (snapshot.labels.empty())
        return;
    const bool roomy = m_layout->taxelSide() >= 8.0;
    const double width = roomy ? std::max(2.0, 0.14 * m_em) : 1.5;
    const double inset = roomy ? 0.5 * width + 1.0 : 0.5 * width;
    m_painter->setBrush(Qt::NoBrush);
    for (const contact::Contact& contact : snapshot.contacts) {
        QPainterPath path;
        for (const OutlineLoop& loop :
             traceOutline(snapshot.labels, snapshot.layout.columns, contact.region,
                          {contact.minRow, contact.maxRow, contact.minColumn, contact.maxColumn})) {
            QPolygonF polygon;
            for (const OutlineCorner& corner : loop)
                polygon << m_layout->gridPoint(corner.column, corner.row) +
                               QPointF(inset * corner.inColumn, -inset * corner.inRow);
            path.addPolygon(polygon);
            path.closeSubpath();
        }
        QPen pen(kCasing, width + 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin);
        m_painter->setPen(pen);
        m_painter->drawPath(path);
        pen.setColor(base::identityColour(contact.id, true));
        pen.setWidthF(width);
        m_painter->setPen(pen);
        m_painter->drawPath(path);
    }
}

int HeatmapPainter::firstColumn(const contact::Contact& contact, int row) const {
    for (int column = contact.minColumn; column < contact.maxColumn; ++column)
        if (m_content->snapshot.labels[m_content->index({row, column})] == contact.region)
            return column;
    return contact.maxColumn;
}

void HeatmapPainter::paintContactLabels() {
    if (m_content->snapshot.labels.empty())
        return;
    const QFont font = base::bold(base::sized(m_painter->font(), base::kSmallText));
    const QFont normal = m_painter->font();
    m_painter->setFont(font);
    const QFontMetricsF metrics(font);
    std::vector<QRectF> taken;
    for (const contact::Contact& contact : m_content->snapshot.contacts) {
        const QString text = QStringLiteral("#%1").arg(contact.id);
        const QSizeF size(metrics.horizontalAdvance(text) + 0.6 * m_em, metrics.height() + 2.0);
        // Above the contact, or below it at the upper edge, so that the label hides little of it.
        const QPointF above = m_layout->gridPoint(firstColumn(contact, contact.maxRow), contact.maxRow + 1.0);
        const QPointF below = m_layout->gridPoint(firstColumn(contact, contact.minRow), contact.minRow);
        const QRectF& visible = m_layout->visible();
        const bool roomAbove = above.y() - size.height() - 1.0 >= visible.top();
        double top = roomAbove ? above.y() - size.height() - 1.0 : below.y() + 1.0;
        top = std::clamp(top, visible.top(), std::max(visible.top(), visible.bottom() - size.height()));
        const double left = std::clamp((roomAbove ? above : below).x(), visible.left(),
                                       std::max(visible.left(), visible.right() - size.width()));
        QRectF chip(QPointF(left, top), size);
        // Beside one that is there, or else not at all: the list of contacts has it.
        for (const QRectF& other : taken)
            if (chip.intersects(other))
                chip.moveLeft(other.right() + 1.0);
        if (chip.right() > visible.right() + 0.5 ||
            std::ranges::any_of(taken, [&](const QRectF& other) { return chip.intersects(other); }))
            continue;
        taken.push_back(chip);
        const QColor colour = base::identityColour(contact.id, true);
        m_painter->setPen(Qt::NoPen);
        m_painter->setBrush(colour);
        m_painter->drawRoundedRect(chip, 2.0, 2.0);
        m_painter->setPen(base::readableOn(colour));
        m_painter->drawText(chip, Qt::AlignCenter, text);
    }
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

void HeatmapPainter::paintAxis() {
    const contact::TactileFeatures& f = m_content->snapshot.features;
    if (!f.alphaZ_rad || !f.cocX_m || !f.cocY_m)
        return;
    const double pitch_m = m_content->snapshot.layout.pitch_m;
    const double long_m = std::max(pitch_m, 2.0 * std::sqrt(f.lambda1_m2.value_or(0.0)));
    const double short_m = std::min(long_m, 2.0 * std::sqrt(f.lambda2_m2.value_or(0.0)));
    const double c = std::cos(*f.alphaZ_rad), s = std::sin(*f.alphaZ_rad);
    const auto at = [&](double along_m, double across_m) {
        return m_layout->pixelOf(*f.cocX_m + along_m * c - across_m * s,
                                 *f.cocY_m + along_m * s + across_m * c);
    };
    const std::optional<QLineF> axis =
        cutToRect(QLineF(at(-long_m, 0.0), at(long_m, 0.0)), m_layout->visible());
    cased(*m_painter, kMark, std::max(1.5, 0.1 * m_em), [&] {
        if (axis)
            m_painter->drawLine(*axis);
        if (short_m > 0.2 * pitch_m) {
            const double tick_m = 0.35 * short_m;
            m_painter->drawLine(at(0.0, -tick_m), at(0.0, tick_m));
        }
    });
}

void HeatmapPainter::paintMarks() {
    const contact::TactileFeatures& f = m_content->snapshot.features;
    const double radius = markRadius();
    const double width = std::max(2.0, 0.14 * m_em);
    m_painter->setBrush(Qt::NoBrush);
    if (m_content->shows(Overlay::centreOfContact) && f.cocX_m && f.cocY_m) {
        const QPointF centre = m_layout->pixelOf(*f.cocX_m, *f.cocY_m);
        cased(*m_painter, kMark, width, [&] { m_painter->drawEllipse(centre, radius, radius); });
    }
    if (m_content->shows(Overlay::centreOfPressure) && f.copX_m && f.copY_m) {
        const QPointF centre = m_layout->pixelOf(*f.copX_m, *f.copY_m);
        cased(*m_painter, kMark, width, [&] { drawCross(*m_painter, centre, 0.85 * radius); });
    }
}

void HeatmapPainter::paintCursor() {
    if (!m_content->cursor)
        return;
    const QRectF rect = m_layout->taxelRect(*m_content->cursor).adjusted(0.5, 0.5, -0.5, -0.5);
    m_painter->setPen(QPen(Qt::black, 3.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    m_painter->drawRect(rect);
    m_painter->setPen(QPen(Qt::white, 1.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    m_painter->drawRect(rect);
}

void HeatmapPainter::paintScales() {
    constexpr double kMillimetres = 1e3;
    const core::ArrayLayout& array = m_content->snapshot.layout;
    const QRectF& visible = m_layout->visible();
    const double pixelsPerMillimetre = m_layout->taxelSide() / (array.pitch_m * kMillimetres);
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
        Qt::AlignRight | Qt::AlignTop, tr("x [mm]"));
    m_painter->drawText(QRectF(yTip.x() - 5.3 * m_em, yTip.y() - 0.5 * m_em, 4.8 * m_em, metrics.height()),
                        Qt::AlignRight | Qt::AlignVCenter, tr("y [mm]"));
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

void HeatmapPainter::paintHeader() {
    const pipeline::TouchSnapshot& snapshot = m_content->snapshot;
    const QRectF rect =
        base::paintProvenance(*m_painter, m_layout->header(), m_content->provenance, m_palette, m_em);
    const QFont normal = m_painter->font();
    const QFont bold = base::bold(base::sized(normal, base::kLargeText));
    double x = rect.left();
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
    const auto pair = [&](const QString& name, const QString& value, const QString& widest) {
        const double nameWidth = widthOf(name, false) + 0.4 * m_em;
        const double valueWidth = std::max(widthOf(value, true), widthOf(widest, true));
        if (x + nameWidth + valueWidth > rect.right())
            return;
        piece(name, false, nameWidth);
        piece(value, true, valueWidth + 1.2 * m_em);
    };
    pair(tr("force"), base::withUnit(m_content->forceText, m_content->unit()), {});
    pair(tr("contacts"), QString::number(snapshot.contacts.size()), QStringLiteral("88"));
    static constexpr std::array kTypes{QT_TR_NOOP("none"), QT_TR_NOOP("point"), QT_TR_NOOP("edge")};
    pair(tr("type"), tr(kTypes[static_cast<std::size_t>(snapshot.features.type)]), {});
    m_painter->setFont(normal);
}

void HeatmapPainter::paintLegend() {
    const pipeline::TouchSnapshot& snapshot = m_content->snapshot;
    const QRectF& rect = m_layout->legend();
    const QColor ink = m_palette.color(QPalette::Text);
    const QFont normal = m_painter->font();
    m_painter->setFont(base::sized(normal, base::kSmallText));
    const QFontMetricsF metrics(m_painter->font());
    m_painter->setRenderHint(QPainter::Antialiasing);
    double x = rect.left();
    const double radius = 0.3 * m_em;
    const auto item = [&](const QString& text, auto&& symbol) {
        const double width = 1.2 * m_em + base::tabularWidth(metrics, text) + m_em;
        if (x + width > rect.right() + m_em)
            return;
        m_painter->setPen(QPen(ink, std::max(1.5, 0.11 * m_em), Qt::SolidLine, Qt::RoundCap));
        m_painter->setBrush(Qt::NoBrush);
        symbol(QPointF(x + 0.5 * m_em, rect.center().y()));
        m_painter->setPen(ink);
        base::drawTabularText(*m_painter, QRectF(x + 1.2 * m_em, rect.top(), width, rect.height()),
                              Qt::AlignLeft | Qt::AlignVCenter, text);
        x += width;
    };
    if (m_content->shows(Overlay::centreOfPressure))
        item(tr("centre of pressure"), [&](const QPointF& p) { drawCross(*m_painter, p, 0.8 * radius); });
    if (m_content->shows(Overlay::centreOfContact))
        item(tr("centre of contact"), [&](const QPointF& p) { m_painter->drawEllipse(p, radius, radius); });
    if (m_content->shows(Overlay::principalAxis))
        item(tr("axis %1\u00b0").arg(m_content->angleText), [&](const QPointF& p) {
            m_painter->drawLine(p - QPointF(0.5 * m_em, 0.0), p + QPointF(0.5 * m_em, 0.0));
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
    base::drawTabularText(*m_painter, m_layout->readout(), Qt::AlignLeft | Qt::AlignVCenter, text);
}

} // namespace teleta::tactile
