// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/view_icons.h"

#include "widgets/base/icons.h"

namespace teleta::view3d {

namespace {

using base::addLine;
using Drawing = base::IconDrawing;

constexpr QPointF kCentre(12.0, 12.0);
constexpr QPointF kNorth(12.0, 3.0), kSouth(12.0, 21.0);
constexpr QPointF kNorthWest(4.2, 7.5), kNorthEast(19.8, 7.5);
constexpr QPointF kSouthWest(4.2, 16.5), kSouthEast(19.8, 16.5);

/// A cube seen from a corner.
void cube(Drawing& d) {
    addLine(d.strokes, {kNorth, kNorthEast, kSouthEast, kSouth, kSouthWest, kNorthWest}, true);
    addLine(d.strokes, {kNorthWest, kCentre, kNorthEast});
    addLine(d.strokes, {kCentre, kSouth});
}

Drawing drawingOf(ViewIcon icon) {
    Drawing d;
    d.stroke = 1.6;
    switch (icon) {
    case ViewIcon::front:
        cube(d);
        addLine(d.fills, {kNorthWest, kCentre, kSouth, kSouthWest}, true);
        break;
    case ViewIcon::top:
        cube(d);
        addLine(d.fills, {kNorth, kNorthEast, kCentre, kNorthWest}, true);
        break;
    case ViewIcon::side:
        cube(d);
        addLine(d.fills, {kNorthEast, kSouthEast, kSouth, kCentre}, true);
        break;
    case ViewIcon::isometric:
        cube(d);
        break;
    case ViewIcon::reset: // a house
        addLine(d.strokes, {{3.0, 12.0}, {12.0, 3.5}, {21.0, 12.0}});
        addLine(d.strokes, {{5.5, 10.5}, {5.5, 20.5}, {18.5, 20.5}, {18.5, 10.5}});
        addLine(d.strokes, {{10.0, 20.5}, {10.0, 14.5}, {14.0, 14.5}, {14.0, 20.5}});
        break;
    case ViewIcon::follow: // a frame around a point
        for (const double sx : {-1.0, 1.0}) {
            for (const double sy : {-1.0, 1.0}) {
                const auto at = [&](double x, double y) { return QPointF(12.0 + sx * x, 12.0 + sy * y); };
                addLine(d.strokes, {at(8.5, 4.0), at(8.5, 8.5), at(4.0, 8.5)});
            }
        }
        d.fills.addEllipse(kCentre, 3.2, 3.2);
        break;
    case ViewIcon::onHand: // a camera behind a plate
        d.strokes.addRect(QRectF(3.5, 7.5, 8.0, 9.0));
        addLine(d.strokes, {{11.5, 10.5}, {15.5, 7.5}, {15.5, 16.5}, {11.5, 13.5}});
        addLine(d.strokes, {{20.5, 3.5}, {20.5, 20.5}});
        break;
    case ViewIcon::parallel: // a box whose edges do not converge
        d.strokes.addRect(QRectF(3.5, 8.5, 12.0, 12.0));
        addLine(d.strokes, {{3.5, 8.5}, {8.5, 3.5}, {20.5, 3.5}, {20.5, 15.5}, {15.5, 20.5}});
        addLine(d.strokes, {{15.5, 8.5}, {20.5, 3.5}});
        break;
    case ViewIcon::plate: // a flat array
        addLine(d.strokes, {{2.5, 15.5}, {8.5, 8.0}, {21.5, 8.0}, {15.5, 15.5}}, true);
        addLine(d.strokes, {{5.5, 11.75}, {18.5, 11.75}});
        addLine(d.strokes, {{9.0, 15.5}, {15.0, 8.0}});
        addLine(d.strokes, {{2.5, 15.5}, {2.5, 18.5}, {15.5, 18.5}, {15.5, 15.5}});
        addLine(d.strokes, {{15.5, 18.5}, {21.5, 11.0}, {21.5, 8.0}});
        break;
    case ViewIcon::cylinder:
        d.strokes.addEllipse(QRectF(2.5, 6.0, 6.0, 12.0));
        d.strokes.moveTo(5.5, 6.0);
        d.strokes.lineTo(18.5, 6.0);
        d.strokes.arcTo(QRectF(15.5, 6.0, 6.0, 12.0), 90.0, -180.0);
        d.strokes.lineTo(5.5, 18.0);
        d.fills.addEllipse(QPointF(14.0, 9.5), 2.2, 1.7);
        break;
    case ViewIcon::grid:
        for (const double at : {3.5, 12.0, 20.5}) {
            addLine(d.strokes, {{at, 3.5}, {at, 20.5}});
            addLine(d.strokes, {{3.5, at}, {20.5, at}});
        }
        break;
    case ViewIcon::axes:
        addLine(d.strokes, {{8.0, 3.0}, {8.0, 15.0}, {21.0, 15.0}});
        addLine(d.strokes, {{8.0, 15.0}, {2.5, 21.0}});
        addLine(d.strokes, {{5.5, 5.5}, {8.0, 3.0}, {10.5, 5.5}});
        addLine(d.strokes, {{18.5, 12.5}, {21.0, 15.0}, {18.5, 17.5}});
        break;
    case ViewIcon::displacement: // from a small point along a way to a large one
        d.fills.addEllipse(QPointF(5.0, 18.5), 2.0, 2.0);
        d.strokes.moveTo(5.0, 18.5);
        d.strokes.cubicTo(8.0, 9.0, 12.0, 16.0, 16.0, 8.5);
        d.fills.addEllipse(QPointF(17.5, 6.5), 3.6, 3.6);
        break;
    case ViewIcon::geometry: // a mesh that leaves
        addLine(d.strokes, {{3.5, 9.5}, {12.0, 4.0}, {12.0, 14.0}}, true);
        addLine(d.strokes, {{3.5, 9.5}, {3.5, 18.5}, {12.0, 14.0}});
        addLine(d.strokes, {{14.5, 19.0}, {21.5, 19.0}});
        addLine(d.strokes, {{18.5, 16.0}, {21.5, 19.0}, {18.5, 22.0}});
        break;
    }
    return d;
}

} // namespace

QIcon viewIcon(ViewIcon icon) {
    return base::themeIcon(drawingOf(icon));
}

} // namespace teleta::view3d
