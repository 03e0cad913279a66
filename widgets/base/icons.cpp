// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include <algorithm>

namespace teleta::base {

namespace {

using Drawing = IconDrawing;

void playTriangle(QPainterPath& path, double left, double right) {
    addLine(path, {{left, 5.0}, {right, 12.0}, {left, 19.0}}, true);
}

Drawing drawingOf(Icon icon) {
    Drawing d;
    switch (icon) {
    case Icon::operate: // a taxel array under a fingertip
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                const QRectF cell(3.5 + 6.0 * column, 3.5 + 6.0 * row, 4.6, 4.6);
                const bool touched =
                    (row == 1 && column == 1) || (row == 1 && column == 2) || (row == 0 && column == 1);
                (touched ? d.fills : d.strokes).addRect(cell);
            }
        break;
    case Icon::patterns: // breakpoints of a lane
        addLine(d.strokes, {{3.0, 18.0}, {8.0, 7.0}, {14.0, 14.0}, {21.0, 5.0}});
        for (const QPointF& p : {QPointF(8.0, 7.0), QPointF(14.0, 14.0)})
            d.fills.addEllipse(p, 2.2, 2.2);
        addLine(d.strokes, {{3.0, 21.0}, {21.0, 21.0}});
        break;
    case Icon::study: // two people
        d.strokes.addEllipse(QPointF(9.0, 8.0), 3.6, 3.6);
        d.strokes.moveTo(2.5, 20.5);
        d.strokes.cubicTo(2.5, 12.0, 15.5, 12.0, 15.5, 20.5);
        d.strokes.arcMoveTo(QRectF(13.0, 4.9, 6.4, 6.4), 110.0);
        d.strokes.arcTo(QRectF(13.0, 4.9, 6.4, 6.4), 110.0, -220.0);
        d.strokes.moveTo(17.5, 14.2);
        d.strokes.cubicTo(20.5, 15.0, 21.5, 17.5, 21.5, 20.5);
        break;
    case Icon::calibrate: // cross hair on a ring
        d.strokes.addEllipse(QPointF(12.0, 12.0), 6.5, 6.5);
        for (const auto& [from, to] :
             {std::pair(QPointF(12, 2.5), QPointF(12, 8.5)), std::pair(QPointF(12, 15.5), QPointF(12, 21.5)),
              std::pair(QPointF(2.5, 12), QPointF(8.5, 12)), std::pair(QPointF(15.5, 12), QPointF(21.5, 12))})
            addLine(d.strokes, {from, to});
        d.fills.addEllipse(QPointF(12.0, 12.0), 1.4, 1.4);
        break;
    case Icon::cost: // error falls with time
        addLine(d.strokes, {{3.5, 3.0}, {3.5, 20.5}, {21.0, 20.5}});
        d.strokes.moveTo(6.5, 5.0);
        d.strokes.cubicTo(8.0, 14.0, 12.0, 16.5, 20.5, 17.0);
        d.fills.addEllipse(QPointF(10.0, 13.2), 2.2, 2.2);
        break;
    case Icon::plot: // two signals on axes, and a cursor
        addLine(d.strokes, {{3.5, 3.0}, {3.5, 20.5}, {21.0, 20.5}});
        d.strokes.moveTo(6.0, 13.0);
        d.strokes.cubicTo(9.0, 1.0, 12.0, 1.0, 14.0, 9.0);
        d.strokes.cubicTo(15.5, 15.0, 18.0, 15.0, 20.5, 7.0);
        addLine(d.strokes, {{6.0, 17.0}, {20.5, 17.0}});
        d.fills.addEllipse(QPointF(14.0, 9.0), 2.2, 2.2);
        break;
    case Icon::play:
        playTriangle(d.fills, 7.0, 19.0);
        break;
    case Icon::pause:
        d.fills.addRect(6.5, 5.0, 4.0, 14.0);
        d.fills.addRect(13.5, 5.0, 4.0, 14.0);
        break;
    case Icon::stepBack:
        playTriangle(d.fills, 15.0, 5.5);
        d.fills.addRect(16.5, 5.0, 2.5, 14.0);
        break;
    case Icon::stepForward:
        playTriangle(d.fills, 9.0, 18.5);
        d.fills.addRect(5.0, 5.0, 2.5, 14.0);
        break;
    case Icon::toStart:
        playTriangle(d.fills, 19.0, 8.5);
        d.fills.addRect(5.0, 5.0, 2.5, 14.0);
        break;
    case Icon::loop:
        d.strokes.moveTo(5.0, 11.0);
        d.strokes.cubicTo(5.0, 7.0, 8.0, 6.0, 10.0, 6.0);
        d.strokes.lineTo(18.0, 6.0);
        addLine(d.strokes, {{15.0, 3.0}, {18.5, 6.0}, {15.0, 9.0}});
        d.strokes.moveTo(19.0, 13.0);
        d.strokes.cubicTo(19.0, 17.0, 16.0, 18.0, 14.0, 18.0);
        d.strokes.lineTo(6.0, 18.0);
        addLine(d.strokes, {{9.0, 15.0}, {5.5, 18.0}, {9.0, 21.0}});
        break;
    case Icon::info:
        d.strokes.addEllipse(QPointF(12.0, 12.0), 9.0, 9.0);
        addLine(d.strokes, {{12.0, 11.0}, {12.0, 17.0}});
        d.fills.addEllipse(QPointF(12.0, 7.3), 1.3, 1.3);
        break;
    case Icon::warning:
        addLine(d.strokes, {{12.0, 3.5}, {21.5, 20.5}, {2.5, 20.5}}, true);
        addLine(d.strokes, {{12.0, 9.5}, {12.0, 14.5}});
        d.fills.addEllipse(QPointF(12.0, 17.5), 1.2, 1.2);
        break;
    case Icon::error:
        addLine(d.strokes,
                {{8.3, 3.0},
                 {15.7, 3.0},
                 {21.0, 8.3},
                 {21.0, 15.7},
                 {15.7, 21.0},
                 {8.3, 21.0},
                 {3.0, 15.7},
                 {3.0, 8.3}},
                true);
        addLine(d.strokes, {{8.8, 8.8}, {15.2, 15.2}});
        addLine(d.strokes, {{15.2, 8.8}, {8.8, 15.2}});
        break;
    case Icon::close:
        addLine(d.strokes, {{6.0, 6.0}, {18.0, 18.0}});
        addLine(d.strokes, {{18.0, 6.0}, {6.0, 18.0}});
        break;
    case Icon::scene: // a box in space
        addLine(d.strokes, {{12.0, 3.0}, {20.0, 7.5}, {20.0, 16.5}, {12.0, 21.0}, {4.0, 16.5}, {4.0, 7.5}},
                true);
        addLine(d.strokes, {{4.0, 7.5}, {12.0, 12.0}, {20.0, 7.5}});
        addLine(d.strokes, {{12.0, 12.0}, {12.0, 21.0}});
        break;
    case Icon::recording: // a page with a trace
        addLine(d.strokes, {{5.0, 3.0}, {14.5, 3.0}, {19.0, 7.5}, {19.0, 21.0}, {5.0, 21.0}}, true);
        addLine(d.strokes, {{14.5, 3.0}, {14.5, 7.5}, {19.0, 7.5}});
        addLine(d.strokes,
                {{7.5, 15.0}, {9.5, 15.0}, {11.0, 11.0}, {13.0, 18.0}, {14.5, 15.0}, {16.5, 15.0}});
        break;
    case Icon::sensor: // plug
        addLine(d.strokes, {{9.0, 3.0}, {9.0, 8.0}});
        addLine(d.strokes, {{15.0, 3.0}, {15.0, 8.0}});
        addLine(d.strokes, {{6.0, 8.0}, {18.0, 8.0}});
        d.strokes.moveTo(7.0, 8.0);
        d.strokes.lineTo(7.0, 11.0);
        d.strokes.cubicTo(7.0, 18.0, 17.0, 18.0, 17.0, 11.0);
        d.strokes.lineTo(17.0, 8.0);
        addLine(d.strokes, {{12.0, 16.5}, {12.0, 21.0}});
        break;
    case Icon::mark: // flag
        addLine(d.strokes, {{6.0, 21.0}, {6.0, 4.0}});
        addLine(d.fills, {{6.0, 4.0}, {18.5, 8.0}, {6.0, 12.0}}, true);
        break;
    case Icon::strips:
        for (const double y : {6.0, 12.0, 18.0})
            addLine(d.strokes,
                    {{3.0, y + 1.5}, {8.0, y + 1.5}, {11.0, y - 1.5}, {15.0, y + 1.0}, {21.0, y - 1.0}});
        break;
    case Icon::more:
        for (const double x : {5.5, 12.0, 18.5})
            d.fills.addEllipse(QPointF(x, 12.0), 1.8, 1.8);
        break;
    }
    return d;
}

class ThemeIconEngine final : public QIconEngine {
public:
    explicit ThemeIconEngine(const IconDrawing& drawing)
        : m_drawing(drawing) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const QPalette palette = QGuiApplication::palette();
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
        paintIcon(*painter, rect, m_drawing, palette.color(group, role));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return result;
    }

    QIconEngine* clone() const override { return new ThemeIconEngine(m_drawing); }

private:
    IconDrawing m_drawing;
};

} // namespace

void addLine(QPainterPath& path, std::initializer_list<QPointF> points, bool closed) {
    const auto* it = points.begin();
    path.moveTo(*it);
    for (++it; it != points.end(); ++it)
        path.lineTo(*it);
    if (closed)
        path.closeSubpath();
}

void paintIcon(QPainter& painter, const QRectF& square, const IconDrawing& drawing, const QColor& colour) {
    constexpr double kGrid = 24.0;
    const double side = std::min(square.width(), square.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(square.center() - QPointF(0.5 * side, 0.5 * side));
    painter.scale(side / kGrid, side / kGrid);
    painter.setPen(QPen(colour, drawing.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(drawing.strokes);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPath(drawing.fills);
    painter.restore();
}

void paintIcon(QPainter& painter, const QRectF& square, Icon icon, const QColor& colour) {
    paintIcon(painter, square, drawingOf(icon), colour);
}

QIcon themeIcon(const IconDrawing& drawing) {
    return QIcon(new ThemeIconEngine(drawing));
}

QIcon themeIcon(Icon icon) {
    return themeIcon(drawingOf(icon));
}

} // namespace teleta::base
