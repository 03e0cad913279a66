// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/residual_picture.h"

#include "backend/core/quantile.h"
#include "backend/vision/camera/nominal_camera.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::camera {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double emOf(const QFont& font) {
    return QFontMetricsF(font).height();
}

/// Largest 1, 2 or 5 times a power of ten up to the value.
double roundDown(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= value)
            return factor * power;
    }
    return power;
}

} // namespace

CalibratedPairs::State CalibratedPairs::state(std::size_t pair) const {
    if (!used[pair])
        return State::excluded;
    if (residuals.empty())
        return State::unknown;
    return residuals[pair].kept ? State::kept : State::outlier;
}

QString ResidualPicture::headline() const {
    if (shown.pairs.empty())
        return surface == Surface::image ? tr("Image: no pairs yet") : tr("Unrolled cylinder: no pairs yet");
    return surface == Surface::image ? tr("Image: from the pixel to where the camera projects its point")
                                     : tr("Unrolled cylinder: from the point to where its pixel is located");
}

QRectF ResidualPicture::extent() const {
    if (surface == Surface::image)
        return {0.0, 0.0, static_cast<double>(shown.width_px), static_cast<double>(shown.height_px)};
    const double low_mm = 1e3 * shown.surface.lowest_z_m;
    const double high_mm = 1e3 * shown.surface.highest_z_m;
    return {-180.0, low_mm, 360.0, high_mm - low_mm};
}

QRectF ResidualPicture::plotRect(const QSizeF& size) const {
    const double em = emOf(font);
    const QRectF all(3.6 * em, 2.4 * em, size.width() - 4.6 * em, size.height() - 6.0 * em);
    if (surface == Surface::cylinder || all.width() <= 0.0 || all.height() <= 0.0)
        return all;
    // Pixels are square.
    const double scale = std::min(all.width() / extent().width(), all.height() / extent().height());
    QRectF plot(0.0, 0.0, scale * extent().width(), scale * extent().height());
    plot.moveTopLeft({all.left() + 0.5 * (all.width() - plot.width()), all.top()});
    return plot;
}

QPointF ResidualPicture::toPlot(const QPointF& value, const QSizeF& size) const {
    const QRectF plot = plotRect(size);
    const QRectF from = extent();
    const double x = (value.x() - from.left()) / from.width();
    const double y = (value.y() - from.top()) / from.height();
    // v increases downwards in an image, z upwards along the cylinder.
    return {plot.left() + x * plot.width(),
            surface == Surface::image ? plot.top() + y * plot.height() : plot.bottom() - y * plot.height()};
}

QPointF ResidualPicture::valueOf(std::size_t pair) const {
    const vision::CalibrationPair& p = shown.pairs[pair];
    if (surface == Surface::image)
        return {p.pixel.x(), p.pixel.y()};
    return {kDegrees * std::atan2(p.p_Sensor_m.y(), p.p_Sensor_m.x()), 1e3 * p.p_Sensor_m.z()};
}

/// In the units of the axes.
std::optional<QPointF> ResidualPicture::shiftOf(std::size_t pair) const {
    if (shown.residuals.empty())
        return std::nullopt;
    const vision::PairResidual& residual = shown.residuals[pair];
    if (surface == Surface::image) {
        if (!residual.error_px)
            return std::nullopt;
        return QPointF(residual.error_px->x(), residual.error_px->y());
    }
    if (!residual.located_m)
        return std::nullopt;
    const Eigen::Vector3d& from = shown.pairs[pair].p_Sensor_m;
    const Eigen::Vector3d& to = *residual.located_m;
    return QPointF(
        kDegrees * std::atan2(from.x() * to.y() - from.y() * to.x(), from.x() * to.x() + from.y() * to.y()),
        1e3 * (to.z() - from.z()));
}

QPointF ResidualPicture::position(std::size_t pair, const QSizeF& size) const {
    return toPlot(valueOf(pair), size);
}

std::optional<QPointF> ResidualPicture::nextPosition(const QSizeF& size) const {
    if (!shown.next_m)
        return std::nullopt;
    const Eigen::Vector3d& next_m = *shown.next_m;
    if (surface == Surface::cylinder)
        return toPlot({kDegrees * std::atan2(next_m.y(), next_m.x()), 1e3 * next_m.z()}, size);
    const auto pixel =
        shown.camera
            ? shown.camera->project(next_m)
            : vision::nominalCamera(shown.width_px, shown.height_px, shown.surface).camera().project(next_m);
    return pixel ? std::optional(toPlot({pixel->x(), pixel->y()}, size)) : std::nullopt;
}

std::optional<std::size_t> ResidualPicture::pairAt(const QPointF& point, const QSizeF& size) const {
    std::optional<std::size_t> nearest;
    double distance = emOf(font);
    for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
        const QPointF d = position(i, size) - point;
        if (std::hypot(d.x(), d.y()) < distance) {
            distance = std::hypot(d.x(), d.y());
            nearest = i;
        }
    }
    return nearest;
}

double ResidualPicture::enlargement(const QSizeF& size) const {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
        const auto shift = shiftOf(i);
        if (!shift || shown.state(i) != CalibratedPairs::State::kept)
            continue;
        const QPointF d = toPlot(valueOf(i) + *shift, size) - position(i, size);
        lengths.push_back(std::hypot(d.x(), d.y()));
    }
    if (lengths.empty())
        return 1.0;
    constexpr double kLargest = 1e6;
    const double usual = core::lowerQuantileOf(lengths, 0.9);
    return usual > 0.0 ? roundDown(std::clamp(2.0 * emOf(font) / usual, 1.0, kLargest)) : 1.0;
}

double ResidualPicture::axialLimit_mm() const {
    std::vector<double> errors_mm;
    for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
        const auto shift = shiftOf(i);
        if (shift && shown.state(i) == CalibratedPairs::State::kept)
            errors_mm.push_back(std::abs(shift->y()));
    }
    if (errors_mm.empty())
        return 1.0;
    const double most = core::lowerQuantileOf(errors_mm, 0.98);
    return most > 0.0 ? most : 1.0;
}

void ResidualPicture::paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    painter.setPen(palette.color(QPalette::Text));
    const double em = emOf(font);
    const QRectF head(em, 0.3 * em, size.width() - 2.0 * em, 1.4 * em);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(font).elidedText(headline(), Qt::ElideRight, head.width()));
    if (plotRect(size).width() <= em || plotRect(size).height() <= em)
        return;
    paintAxes(painter, size, palette);
    paintPairs(painter, size, palette);
}

void ResidualPicture::paintAxes(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    const QRectF plot = plotRect(size);
    const double em = emOf(font);
    const QColor faint = base::mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(faint, 1.0));
    painter.drawRect(plot);
    const QFont small = base::sized(font, base::kSmallText);
    painter.setFont(small);
    const bool image = surface == Surface::image;
    const QRectF range = extent();
    const double stepX = image ? 400.0 : 90.0;
    const double stepY = image ? 400.0 : 20.0;
    const auto label = [&](double value) { return base::wholeNumber(value).trimmed(); };
    for (double x = std::ceil(range.left() / stepX) * stepX; x <= range.right() + 1e-9; x += stepX) {
        const QPointF at = toPlot({x, image ? range.bottom() : range.top()}, size);
        painter.setPen(QPen(faint, 1.0));
        painter.drawLine(QPointF(at.x(), plot.top()), QPointF(at.x(), plot.bottom()));
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(at.x() - 3 * em, plot.bottom() + 0.1 * em, 6 * em, 1.1 * em), Qt::AlignCenter,
                         label(x));
    }
    for (double y = std::ceil(range.top() / stepY) * stepY; y <= range.bottom() + 1e-9; y += stepY) {
        const QPointF at = toPlot({range.left(), y}, size);
        painter.setPen(QPen(faint, 1.0));
        painter.drawLine(QPointF(plot.left(), at.y()), QPointF(plot.right(), at.y()));
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(plot.left() - 3.4 * em, at.y() - 0.6 * em, 3.1 * em, 1.2 * em),
                         Qt::AlignRight | Qt::AlignVCenter, label(y));
    }
    const QString axes = image ? tr("u to the right, v down, px") : tr("angle, degrees; z upwards, mm");
    // Uses the full width of the picture: the plot may be narrower than its text.
    painter.drawText(QRectF(0.5 * em, plot.bottom() + 1.2 * em, plot.right() - 0.5 * em, 1.1 * em),
                     Qt::AlignRight, axes);
    if (!image || !shown.camera)
        return;
    const vision::CameraParameters& camera = shown.camera->parameters();
    const QPointF centre = toPlot({camera.cx_px, camera.cy_px}, size);
    const double radius = shown.camera->validRadius_px() * plot.width() / range.width();
    painter.save();
    painter.setClipRect(plot);
    painter.setPen(QPen(base::statusColours(palette).stale, 1.5, Qt::DashLine));
    painter.drawEllipse(centre, radius, radius);
    painter.drawLine(centre - QPointF(0.4 * em, 0.0), centre + QPointF(0.4 * em, 0.0));
    painter.drawLine(centre - QPointF(0.0, 0.4 * em), centre + QPointF(0.0, 0.4 * em));
    painter.restore();
}

void ResidualPicture::paintPairs(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    using State = CalibratedPairs::State;
    const double em = emOf(font);
    const double factor = enlargement(size);
    const double limit_mm = axialLimit_mm();
    const bool image = surface == Surface::image;
    const base::StatusColours& colours = base::statusColours(palette);
    painter.save();
    painter.setClipRect(plotRect(size).adjusted(-1, -1, 1, 1));
    for (std::size_t i = 0; i < shown.pairs.size(); ++i) {
        const QPointF at = position(i, size);
        const State state = shown.state(i);
        const auto shift = shiftOf(i);
        const double r = 0.16 * em;
        if (state == State::kept && shift) {
            const QPointF to = at + factor * (toPlot(valueOf(i) + *shift, size) - at);
            painter.setPen(QPen(palette.color(QPalette::Text), 1.2));
            painter.drawLine(at, to);
        }
        if (state == State::outlier) {
            painter.setPen(QPen(colours.lost, 1.8));
            painter.drawLine(at - QPointF(1.4 * r, 1.4 * r), at + QPointF(1.4 * r, 1.4 * r));
            painter.drawLine(at - QPointF(1.4 * r, -1.4 * r), at + QPointF(1.4 * r, -1.4 * r));
        } else if (state == State::excluded) {
            painter.setPen(QPen(colours.neutral, 1.2));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(at, 1.3 * r, 1.3 * r);
        } else {
            QColor fill = state == State::kept ? colours.live : colours.neutral;
            if (!image && state == State::kept && shift)
                fill = QColor::fromRgb(base::colourAt(base::diverging(), 0.5 + 0.5 * shift->y() / limit_mm));
            painter.setPen(
                image ? QPen(Qt::NoPen)
                      : QPen(base::mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.5),
                             0.8));
            painter.setBrush(fill);
            const double radius = image ? r : 1.7 * r;
            painter.drawEllipse(at, radius, radius);
        }
        if (selected == i) {
            painter.setPen(QPen(palette.color(QPalette::Highlight), 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(at, 0.6 * em, 0.6 * em);
        }
    }
    paintNext(painter, size, palette);
    painter.restore();
    paintScale(painter, size, palette, limit_mm);
}

void ResidualPicture::paintNext(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    const auto at = nextPosition(size);
    if (!at)
        return;
    const double em = emOf(font);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette.color(QPalette::Highlight), 3.0));
    painter.drawEllipse(*at, 0.7 * em, 0.7 * em);
    painter.setBrush(palette.color(QPalette::Highlight));
    painter.drawEllipse(*at, 0.15 * em, 0.15 * em);
}

void ResidualPicture::paintScale(QPainter& painter, const QSizeF& size, const QPalette& palette,
                                 double limit_mm) const {
    if (shown.residuals.empty())
        return;
    const QRectF plot = plotRect(size);
    const double em = emOf(font);
    painter.setFont(base::sized(font, base::kSmallText));
    painter.setPen(palette.color(QPalette::Text));
    QString text = tr("arrows enlarged %1 times").arg(base::wholeNumber(enlargement(size)).trimmed());
    const QFontMetricsF metrics(painter.font());
    const double right = size.width() - 0.5 * em;
    QRectF line(plot.left(), plot.bottom() + 2.2 * em, plot.width(), 1.1 * em);
    if (surface == Surface::image) {
        text += QStringLiteral("   ") + tr("x: wrong pair   o: excluded   dashed: valid radius");
        line.setLeft(std::clamp(right - metrics.horizontalAdvance(text), 0.5 * em, plot.left()));
        line.setRight(right);
        painter.drawText(line, Qt::AlignLeft, metrics.elidedText(text, Qt::ElideRight, line.width()));
        return;
    }
    const QString limit = base::threeDigits(limit_mm).trimmed();
    const QString low = tr("along z \u2212%1").arg(limit);
    const QString high = tr("+%1 mm").arg(limit);
    const double low_px = metrics.horizontalAdvance(low) + 0.5 * em;
    const double high_px = metrics.horizontalAdvance(high) + 0.5 * em;
    // Keeps the scale clear of the text on its left.
    const double room_px = right - line.left() - metrics.horizontalAdvance(text) - em;
    const double width = std::clamp(room_px - low_px - high_px, 2.0 * em, 8.0 * em);
    const QRectF bar(right - high_px - width, line.top() + 0.2 * em, width, 0.7 * em);
    line.setRight(bar.left() - low_px - 0.5 * em);
    painter.drawText(line, Qt::AlignLeft, metrics.elidedText(text, Qt::ElideRight, line.width()));
    for (int i = 0; i < static_cast<int>(bar.width()); ++i)
        painter.fillRect(QRectF(bar.left() + i, bar.top(), 1.5, bar.height()),
                         QColor::fromRgb(base::colourAt(base::diverging(), i / bar.width())));
    painter.drawText(QRectF(bar.left() - low_px, line.top(), low_px - 0.2 * em, 1.1 * em), Qt::AlignRight,
                     low);
    painter.drawText(QRectF(bar.right() + 0.2 * em, line.top(), high_px, 1.1 * em), Qt::AlignLeft, high);
}

} // namespace teleta::camera
