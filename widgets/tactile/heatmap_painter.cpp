// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_painter.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/contact_outline.h"
#include "widgets/tactile/heatmap_ink.h"
#include "widgets/tactile/place_discs.h"
#include "widgets/tactile/shear_arrows.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <vector>

namespace teleta::tactile {

namespace {

const QColor kDeadGround(0xff, 0xff, 0xff, 0x48);
const QColor kDeadHatch(0xe8, 0xe8, 0xe8);

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
    if (content.shows(Overlay::shear))
        paintShear(painter, layout, content);
    if (content.shows(Overlay::principalAxis))
        paintAxis();
    paintMarks();
    if (content.shows(Overlay::contacts) && layout.labels().isEmpty())
        paintContactLabels();
    paintCursor();
    if (content.old)
        paintVeil();
    painter.restore();
    if (content.shows(Overlay::contacts) && !layout.labels().isEmpty())
        paintLabelsBeside();
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

double HeatmapPainter::markRadius() const {
    return std::clamp(0.32 * m_layout->taxelSide(), 0.3 * m_em, 0.6 * m_em);
}

void HeatmapPainter::paintTaxels(Medium medium) {
    const core::ArrayLayout& array = m_content->snapshot.layout.grid();
    const base::ColourMap& map = base::cividis();
    const std::vector<float>& loads = m_content->snapshot.load_N;
    if (!m_content->snapshot.layout.isGrid()) {
        paintDiscs(*m_painter, *m_layout, *m_content);
        return;
    }
    if (medium == Medium::paper) {
        m_painter->setPen(Qt::NoPen);
        for (int row = 0; row < array.rows; ++row)
            for (int column = 0; column < array.columns; ++column) {
                if (m_content->snapshot.layout.isAbsent(m_content->index({row, column})))
                    continue;
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
    if (!m_content->snapshot.layout.absent().empty())
        paintAbsent();
    m_painter->drawImage(m_layout->sensor(), m_image);
}

/// Places without a taxel have the colour of the ground.
void HeatmapPainter::paintAbsent() {
    const core::ArrayLayout& array = m_content->snapshot.layout.grid();
    const QRgb ground = m_palette.color(QPalette::Base).rgb();
    for (int row = 0; row < array.rows; ++row)
        for (int column = 0; column < array.columns; ++column)
            if (m_content->snapshot.layout.isAbsent(m_content->index({row, column})))
                m_image.setPixel(column, array.rows - 1 - row, ground);
}

void HeatmapPainter::paintGrid() {
    constexpr double kSmallestSide = 9.0;
    if (m_layout->taxelSide() < kSmallestSide || !m_content->snapshot.layout.isGrid())
        return;
    const core::ArrayLayout& array = m_content->snapshot.layout.grid();
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
    const core::TaxelLayout& layout = m_content->snapshot.layout;
    if (m_content->snapshot.dead.empty() || !layout.isGrid())
        return;
    const core::ArrayLayout& array = m_content->snapshot.layout.grid();
    const double spacing = std::max(3.0, m_layout->taxelSide() / 3.0);
    m_painter->setRenderHint(QPainter::Antialiasing);
    for (int row = 0; row < array.rows; ++row)
        for (int column = 0; column < array.columns; ++column) {
            const std::size_t i = m_content->index({row, column});
            if (!m_content->isDead(i) || layout.isAbsent(i))
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
    const core::ArrayLayout& array = m_content->snapshot.layout.grid();
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
    if (!snapshot.layout.isGrid()) {
        paintDiscRings(*m_painter, *m_layout, *m_content, width);
        return;
    }
    m_painter->setBrush(Qt::NoBrush);
    for (const contact::Contact& contact : snapshot.contacts) {
        QPainterPath path;
        // Open at the seam beyond which it goes on.
        const bool open = m_content->isPart(contact);
        const auto atSeam = [&](const OutlineCorner& corner) {
            return open && (corner.row == 0 || corner.row == snapshot.layout.grid().rows);
        };
        const auto place = [&](const OutlineCorner& corner) {
            return m_layout->gridPoint(corner.column, corner.row) +
                   QPointF(inset * corner.inColumn, atSeam(corner) ? 0.0 : -inset * corner.inRow);
        };
        for (const OutlineLoop& loop :
             traceOutline(snapshot.labels, snapshot.layout.grid().columns, contact.region,
                          {contact.minRow, contact.maxRow, contact.minColumn, contact.maxColumn})) {
            path.moveTo(place(loop.front()));
            bool whole = true;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const OutlineCorner& to = loop[(i + 1) % loop.size()];
                const bool gap = atSeam(loop[i]) && to.row == loop[i].row;
                whole = whole && !gap;
                if (gap)
                    path.moveTo(place(to));
                else
                    path.lineTo(place(to));
            }
            if (whole)
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

DiscEnds HeatmapPainter::endsOf(const contact::Contact& contact) const {
    if (!m_content->snapshot.layout.isGrid())
        return discEndsOf(*m_layout, *m_content, contact);
    return {m_layout->gridPoint(firstColumn(contact, contact.maxRow), contact.maxRow + 1.0),
            m_layout->gridPoint(firstColumn(contact, contact.minRow), contact.minRow)};
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
        const auto [above, below] = endsOf(contact);
        const QRectF& visible = m_layout->visible();
        const bool roomAbove = above.y() - size.height() - 1.0 >= visible.top();
        double top = roomAbove ? above.y() - size.height() - 1.0 : below.y() + 1.0;
        top = std::clamp(top, visible.top(), std::max(visible.top(), visible.bottom() - size.height()));
        const double left = std::clamp((roomAbove ? above : below).x(), visible.left(),
                                       std::max(visible.left(), visible.right() - size.width()));
        QRectF chip(QPointF(left, top), size);
        // Beside those that are there, or else not at all: the list of contacts has it.
        const auto isFree = [&] {
            return chip.left() >= visible.left() && chip.right() <= visible.right() + 0.5 &&
                   std::ranges::none_of(taken, [&](const QRectF& other) { return chip.intersects(other); });
        };
        for (const QRectF& other : taken)
            if (chip.intersects(other))
                chip.moveLeft(other.right() + 1.0);
        if (!isFree()) {
            chip.moveLeft(left);
            for (const QRectF& other : taken)
                if (chip.intersects(other))
                    chip.moveRight(other.left() - 1.0);
        }
        if (!isFree())
            continue;
        taken.push_back(chip);
        paintChip(chip, contact.id, text);
    }
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

void HeatmapPainter::paintChip(const QRectF& chip, int id, const QString& text) {
    const QColor colour = base::identityColour(id, true);
    m_painter->setPen(Qt::NoPen);
    m_painter->setBrush(colour);
    m_painter->drawRoundedRect(chip, 2.0, 2.0);
    m_painter->setPen(base::readableOn(colour));
    m_painter->drawText(chip, Qt::AlignCenter, text);
}

/// Each at the height of its contact, or as near as the others leave room, with a line to it.
void HeatmapPainter::paintLabelsBeside() {
    if (m_content->snapshot.labels.empty())
        return;
    const QFont normal = m_painter->font();
    const QFont font = base::bold(base::sized(normal, base::kSmallText));
    m_painter->setFont(font);
    m_painter->setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font);
    const QRectF& room = m_layout->labels();
    const double height = metrics.height() + 2.0;
    struct Label {
        int id = 0;
        QPointF at;
        double top = 0.0;
    };
    std::vector<Label> labels;
    for (const contact::Contact& contact : m_content->snapshot.contacts) {
        const auto [above, below] = endsOf(contact);
        const QPointF at(above.x(), 0.5 * (above.y() + below.y()));
        if (m_layout->visible().contains(at))
            labels.push_back({contact.id, at, at.y() - 0.5 * height});
    }
    std::ranges::sort(labels, {}, [](const Label& label) { return label.at.y(); });
    double next = room.top();
    for (Label& label : labels) {
        label.top = std::max(label.top, next);
        next = label.top + height + 1.0;
    }
    double last = room.bottom();
    for (Label& label : labels | std::views::reverse) {
        label.top = std::min(label.top, last - height);
        last = label.top - 1.0;
    }
    for (const Label& label : labels) {
        if (label.top < room.top() - 0.5)
            continue; // more than there is room for: the list of contacts has them
        const QString text = QStringLiteral("#%1").arg(label.id);
        const QRectF chip(room.left(), label.top,
                          std::min(room.width(), metrics.horizontalAdvance(text) + 0.6 * m_em), height);
        m_painter->setPen(QPen(base::identityColour(label.id, true), 1.0));
        m_painter->drawLine(QPointF(chip.left(), chip.center().y()), label.at);
        paintChip(chip, label.id, text);
    }
    m_painter->setRenderHint(QPainter::Antialiasing, false);
    m_painter->setBrush(Qt::NoBrush);
    m_painter->setFont(normal);
}

void HeatmapPainter::paintAxis() {
    const contact::TactileFeatures& f = m_content->snapshot.features;
    if (!f.alphaZ_rad || !f.cocX_m || !f.cocY_m)
        return;
    const double pitch_m = m_content->snapshot.layout.pitch_m();
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

} // namespace teleta::tactile
