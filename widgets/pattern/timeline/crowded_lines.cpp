// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/timeline/crowded_lines.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace teleta::pattern {

namespace {

constexpr qsizetype kCrowded = 300;
constexpr double kPiece_px = 64.0;
constexpr qsizetype kPieceCorners = 128;

/// The part of a line with rising x in [from, to].
QPolygonF stretchOf(const QPolygonF& line, double from, double to) {
    const auto crossing = [](const QPointF& a, const QPointF& b, double x) {
        return QPointF(x, a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x()));
    };
    const auto first = std::lower_bound(line.begin(), line.end(), from,
                                        [](const QPointF& point, double x) { return point.x() < x; });
    const auto last =
        std::upper_bound(first, line.end(), to, [](double x, const QPointF& point) { return x < point.x(); });
    QPolygonF stretch;
    if (first != line.begin() && first != line.end() && first->x() > from)
        stretch << crossing(*(first - 1), *first, from);
    std::copy(first, last, std::back_inserter(stretch));
    if (last != line.begin() && last != line.end() && (last - 1)->x() < to)
        stretch << crossing(*(last - 1), *last, to);
    return stretch;
}

void fill(QPainter& painter, QPolygonF shape, const QPolygonF& back) {
    std::reverse_copy(back.begin(), back.end(), std::back_inserter(shape));
    painter.drawPolygon(shape, Qt::OddEvenFill);
}

} // namespace

void fillBetween(QPainter& painter, const QPolygonF& one, const QPolygonF& other) {
    if (one.size() + other.size() <= kCrowded) {
        fill(painter, one, other);
        return;
    }
    for (double x = std::floor(one.first().x()); x < one.last().x(); x += kPiece_px)
        fill(painter, stretchOf(one, x, x + kPiece_px), stretchOf(other, x, x + kPiece_px));
}

void strokeLine(QPainter& painter, const QPolygonF& line, const QPen& pen) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    if (line.size() <= kCrowded) {
        painter.drawPolyline(line);
        return;
    }
    QPen plain = pen;
    plain.setJoinStyle(Qt::BevelJoin);
    plain.setCapStyle(Qt::FlatCap);
    painter.setPen(plain);
    for (qsizetype k = 0; k + 1 < line.size(); k += kPieceCorners)
        painter.drawPolyline(line.constData() + k,
                             static_cast<int>(std::min(kPieceCorners + 1, line.size() - k)));
}

} // namespace teleta::pattern
