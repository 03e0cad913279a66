// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/contour_picture.h"

#include "backend/figure/round_step.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/theme.h"
#include "widgets/touch/touch_texts.h"

#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::touch {

namespace {

/// A contour smaller than this is shown as if it were this large: a point has no extent to scale.
constexpr double kSmallestExtent_m = 0.005;

QPointF toPoint(const contour::Point& p) {
    return {p.x(), p.y()};
}

/// The parts of a circle that lie in a rectangle, because SVG pictures have no clipping.
void drawCircleIn(QPainter& painter, const QRectF& rect, const QPointF& centre, double radius) {
    constexpr int kSteps = 720;
    QPolygonF part;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSteps;
        const QPointF at = centre + radius * QPointF(std::cos(angle), std::sin(angle));
        if (rect.contains(at))
            part << at;
        if (!rect.contains(at) || i == kSteps) {
            painter.drawPolyline(part);
            part.clear();
        }
    }
}

} // namespace

QString ContourPicture::headline() const {
    if (contour.points_m.empty())
        return tr("nothing explored yet");
    if (!contour.recognition)
        return contour.points_m.size() < contour.kLeastOfAPoint
                   ? tr("too few touches for a shape")
                   : TouchTexts::shape(teleta::contour::Shape::unknown);
    if (contour.recognition->candidates().size() > 1)
        return tr("undecided: %1").arg(TouchTexts::recognition(*contour.recognition));
    return tr("%1, confidence %2 %")
        .arg(TouchTexts::shape(contour.recognition->shape))
        .arg(std::lround(100.0 * contour.recognition->confidence));
}

QString ContourPicture::details() const {
    if (contour.points_m.empty())
        return tr("Touch an object from several sides: its outline appears here.");
    QStringList parts{tr("%n point(s)", nullptr, static_cast<int>(contour.points_m.size()))};
    if (contour.recognition) {
        const teleta::contour::Recognition& seen = *contour.recognition;
        if (seen.circle)
            parts << tr("radius %1").arg(base::millimetres(seen.circle->radius_m));
        if (seen.vertices_m.size() > 1) {
            QStringList edges;
            const std::size_t count = seen.vertices_m.size() - (seen.closed ? 0 : 1);
            for (std::size_t i = 0; i < count; ++i)
                edges << base::millimetres(
                    (seen.vertices_m[(i + 1) % seen.vertices_m.size()] - seen.vertices_m[i]).norm());
            parts << tr("edges %1").arg(edges.join(QStringLiteral(", ")));
        }
        if (contour.points_m.size() > 2)
            parts << tr("points off by %1 (rms)").arg(base::millimetres(seen.rms_m));
    }
    parts << tr("z %1").arg(base::millimetres(contour.height_m));
    return parts.join(QStringLiteral("   "));
}

QRectF ContourPicture::plotRect(const QSizeF& size) const {
    const double em = QFontMetricsF(font).height();
    return QRectF(4.0 * em, 4.3 * em, size.width() - 5.0 * em, size.height() - 6.5 * em);
}

std::optional<QTransform> ContourPicture::mapping(const QSizeF& size) const {
    const QRectF plot = plotRect(size);
    if (contour.points_m.empty() || plot.width() < 10.0 || plot.height() < 10.0)
        return std::nullopt;
    QPolygonF all;
    for (const teleta::contour::Point& p : contour.points_m)
        all << toPoint(p);
    for (const teleta::contour::Point& p : contour.curve_m)
        all << toPoint(p);
    const QRectF box = all.boundingRect();
    const double extent_m = std::max({box.width(), box.height(), kSmallestExtent_m});
    const double margin = 1.15;
    const double scale = std::min(plot.width() / (margin * std::max(box.width(), 0.5 * extent_m)),
                                  plot.height() / (margin * std::max(box.height(), 0.5 * extent_m)));
    QTransform transform;
    transform.translate(plot.center().x(), plot.center().y());
    transform.scale(scale, -scale);
    transform.translate(-box.center().x(), -box.center().y());
    return transform;
}

void ContourPicture::paintAxes(QPainter& painter, const QRectF& plot, const QTransform& toPlot,
                               const QPalette& palette) const {
    const QFont small = base::sized(font, base::kSmallText);
    const double line = QFontMetricsF(small).height();
    const QRectF seen = toPlot.inverted().mapRect(plot);
    const double step_m = figure::roundStep(seen.width() / std::max(plot.width() / (6.0 * line), 1.0));
    const QColor text = palette.color(QPalette::PlaceholderText);
    const QColor grid = base::mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.1);
    painter.setFont(small);
    const auto label = [step_m](double value_m) {
        return base::fixedDigits(value_m * 1e3, step_m < 1e-3 ? 1 : 0);
    };
    for (double x_m = std::ceil(seen.left() / step_m) * step_m; x_m <= seen.right(); x_m += step_m) {
        const double x = toPlot.map(QPointF(x_m, 0.0)).x();
        painter.setPen(QPen(grid, 1.0));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - 3.0 * line, plot.bottom() + 0.15 * line, 6.0 * line, line),
                         Qt::AlignCenter, label(x_m));
    }
    for (double y_m = std::ceil(seen.top() / step_m) * step_m; y_m <= seen.bottom(); y_m += step_m) {
        const double y = toPlot.map(QPointF(0.0, y_m)).y();
        painter.setPen(QPen(grid, 1.0));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(plot.left() - 4.2 * line, y - 0.5 * line, 4.0 * line, line),
                         Qt::AlignRight | Qt::AlignVCenter, label(y_m));
    }
    painter.setPen(text);
    painter.drawText(QRectF(plot.right() - 6.0 * line, plot.bottom() + 1.1 * line, 6.0 * line, line),
                     Qt::AlignRight | Qt::AlignVCenter, base::titleWithUnit(tr("x"), QStringLiteral("mm")));
    painter.drawText(QRectF(plot.left() - 4.0 * line, plot.top() - 1.2 * line, 6.0 * line, line),
                     Qt::AlignLeft | Qt::AlignVCenter, base::titleWithUnit(tr("y"), QStringLiteral("mm")));
}

void ContourPicture::paintShape(QPainter& painter, const QRectF& plot, const QTransform& toPlot,
                                const QPalette& palette) const {
    const double em = QFontMetricsF(font).height();
    const QColor curve = palette.color(QPalette::Link);
    const QColor vertex = base::statusColours(palette).stale;
    if (contour.recognition && contour.recognition->circle) {
        const teleta::contour::Circle& circle = *contour.recognition->circle;
        const double radius = circle.radius_m * toPlot.m11();
        painter.setPen(QPen(vertex, 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        drawCircleIn(painter, plot, toPlot.map(toPoint(circle.centre_m)), radius);
    }
    // Between touches that lie close together at a corner the spline turns as it likes: the shape that was
    // recognised is what is to be seen.
    const bool hasEdges = contour.recognition && contour.recognition->vertices_m.size() > 1;
    QPolygonF line;
    for (const teleta::contour::Point& p : contour.curve_m)
        line << toPlot.map(toPoint(p));
    painter.setPen(hasEdges ? QPen(base::mixed(palette.color(QPalette::Base), curve, 0.4), 1.0)
                            : QPen(curve, 2.0));
    painter.drawPolyline(line);
    if (hasEdges) {
        QPolygonF edges;
        for (const teleta::contour::Point& p : contour.recognition->vertices_m)
            edges << toPlot.map(toPoint(p));
        if (contour.recognition->closed)
            edges << edges.front();
        painter.setPen(QPen(vertex, 2.0, Qt::DashLine));
        painter.drawPolyline(edges);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Text));
    for (const teleta::contour::Point& p : contour.points_m)
        painter.drawEllipse(toPlot.map(toPoint(p)), 0.16 * em, 0.16 * em);
    painter.setPen(QPen(palette.color(QPalette::Text), 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(toPlot.map(toPoint(contour.points_m.front())), 0.32 * em, 0.32 * em);
    if (!contour.recognition)
        return;
    painter.setPen(QPen(vertex, 2.0));
    for (const teleta::contour::Point& p : contour.recognition->vertices_m) {
        const QPointF at = toPlot.map(toPoint(p));
        const double r = 0.38 * em;
        painter.drawPolygon(
            QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)});
    }
}

void ContourPicture::paintHead(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    const double em = QFontMetricsF(font).height();
    painter.setFont(font);
    const QRectF head = base::paintProvenance(
        painter, QRectF(0.5 * em, 0.3 * em, size.width() - em, 1.5 * em), provenance, palette, 0.5 * em);
    const QFont large = base::sized(font, base::kLargeText);
    painter.setFont(large);
    painter.setPen(palette.color(contour.points_m.empty() ? QPalette::PlaceholderText : QPalette::Text));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(large).elidedText(headline(), Qt::ElideRight, head.width()));
    const QFont small = base::sized(font, base::kSmallText);
    painter.setFont(small);
    painter.setPen(palette.color(QPalette::PlaceholderText));
    const QRectF below(head.left(), head.bottom(), size.width() - em, 1.1 * em);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(small).elidedText(details(), Qt::ElideRight, below.width()));
}

void ContourPicture::paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    painter.setRenderHint(QPainter::Antialiasing);
    paintHead(painter, size, palette);
    const auto toPlot = mapping(size);
    if (!toPlot)
        return;
    paintAxes(painter, plotRect(size), *toPlot, palette);
    paintShape(painter, plotRect(size), *toPlot, palette);
}

QString ContourPicture::csv() const {
    QString text = QStringLiteral("x_m,y_m\n");
    for (const teleta::contour::Point& p : contour.points_m)
        text += base::csvNumber(p.x()) + u',' + base::csvNumber(p.y()) + u'\n';
    return text;
}

} // namespace teleta::touch
