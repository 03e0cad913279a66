// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/camera_picture.h"

#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"
#include "widgets/camera/picture_marks.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace teleta::camera {

namespace {

using vision::ContactEvent;
using vision::FollowedContact;

constexpr int kArrowColours = 32;

/// Refers to the pixels without copying them.
QImage imageOf(const core::GreyImage& image) {
    return {image.pixels.get(), image.width_px, image.height_px, image.width_px, QImage::Format_Grayscale8};
}

QPointF pointOf(const auto& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

} // namespace

double CameraPicture::scale(const QSizeF& size) const {
    const core::GreyImage& image = shown.image.isEmpty() ? shown.preview : shown.image;
    if (image.isEmpty())
        return 1.0;
    return zoom * std::min(size.width() / image.width_px, size.height() / image.height_px);
}

QRectF CameraPicture::imageRect(const QSizeF& size) const {
    const double perPixel = scale(size);
    const QSizeF extent(shown.image.width_px * perPixel, shown.image.height_px * perPixel);
    const QPointF middle(0.5 * size.width(), 0.5 * size.height());
    return {middle - QPointF(centre.x() * extent.width(), centre.y() * extent.height()), extent};
}

QPointF CameraPicture::toPicture(const QPointF& pixel, const QSizeF& size) const {
    // The centre of the upper left pixel is (0, 0).
    return imageRect(size).topLeft() + scale(size) * (pixel + QPointF(0.5, 0.5));
}

QPointF CameraPicture::toPixel(const QPointF& point, const QSizeF& size) const {
    return (point - imageRect(size).topLeft()) / scale(size) - QPointF(0.5, 0.5);
}

void CameraPicture::zoomAt(const QPointF& point, const QSizeF& size, double factor) {
    const QPointF pixel = toPixel(point, size);
    zoom = std::clamp(zoom * factor, 1.0, kLargestZoom);
    moveBy(point - toPicture(pixel, size), size);
}

void CameraPicture::moveBy(const QPointF& way, const QSizeF& size) {
    const QRectF image = imageRect(size);
    const auto moved = [](double share, double way_px, double extent_px, double room_px) {
        const double half = std::min(0.5, 0.5 * room_px / std::max(extent_px, 1.0));
        return std::clamp(share - way_px / std::max(extent_px, 1.0), half, 1.0 - half);
    };
    centre = {moved(centre.x(), way.x(), image.width(), size.width()),
              moved(centre.y(), way.y(), image.height(), size.height())};
}

int CameraPicture::contactAt(const QPointF& point, const QSizeF& size) const {
    const QPointF pixel = toPixel(point, size);
    for (std::size_t i = 0; i < shown.contacts.size(); ++i) {
        QPolygonF outline;
        for (const auto& corner : shown.contacts[i].contact.contour_px)
            outline << pointOf(corner);
        if (outline.containsPoint(pixel, Qt::OddEvenFill))
            return static_cast<int>(i);
    }
    return -1;
}

QString CameraPicture::wordsFor(const FollowedContact& followed) const {
    const vision::CameraContact& contact = followed.contact;
    QString text = tr("Contact %1").arg(contact.id);
    if (contact.located) {
        const Eigen::Vector3d& p = contact.p_Sensor_Centre_m;
        text += QLatin1Char('\n') + tr("at %1 along the tube, %2\u00b0 around it")
                                        .arg(base::millimetres(p.z()))
                                        .arg(std::lround(std::atan2(p.y(), p.x()) * 180.0 / M_PI));
        if (std::isfinite(contact.sd_m))
            text += QLatin1Char('\n') + tr("standard deviation %1").arg(base::millimetres(contact.sd_m));
        text += QLatin1Char('\n') +
                tr("moved %1 since it began").arg(base::millimetres(followed.displacement_m().norm()));
    }
    if (std::isfinite(contact.depth_m))
        text += QLatin1Char('\n') + tr("%1 deep").arg(base::millimetres(contact.depth_m));
    return text;
}

void CameraPicture::paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    painter.save();
    painter.setFont(font);
    painter.setClipRect(QRectF(QPointF(), size));
    if (isEmpty()) {
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.drawText(QRectF(QPointF(), size), Qt::AlignCenter | Qt::TextWordWrap, tr("No picture yet"));
    } else {
        paintImage(painter, size);
        painter.setRenderHint(QPainter::Antialiasing);
        if (arrows)
            paintArrows(painter, size);
        paintContacts(painter, size);
    }
    paintState(painter, size, palette);
    painter.restore();
}

void CameraPicture::paintImage(QPainter& painter, const QSizeF& size) const {
    const QRectF target = imageRect(size);
    // The preview was reduced with smoothing; smoothing again when enlarging would blur it.
    const bool close = scale(size) * shown.image.width_px > 1.5 * shown.preview.width_px;
    const QImage image = imageOf(close ? shown.image : shown.preview);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale(size) < 3.0);
    const QRectF visible = target & QRectF(QPointF(), size);
    const double perPixel = target.width() / image.width();
    painter.drawImage(visible, image,
                      QRectF((visible.topLeft() - target.topLeft()) / perPixel, visible.size() / perPixel));
    if (!shown.usable)
        painter.fillRect(visible, QColor(0, 0, 0, 110));
}

void CameraPicture::paintArrows(QPainter& painter, const QSizeF& size) const {
    double longest_px = 4.0;
    for (const auto& arrow : shown.arrows)
        longest_px =
            std::max(longest_px, std::hypot(pointOf(arrow.moved_px).x(), pointOf(arrow.moved_px).y()));
    std::array<QVector<QLineF>, kArrowColours> lines;
    QVector<QPointF> still;
    for (const auto& arrow : shown.arrows) {
        const QPointF at = pointOf(arrow.at_px);
        const QPointF moved = pointOf(arrow.moved_px);
        const double length_px = std::hypot(moved.x(), moved.y());
        if (!(length_px >= kLeastArrow_px)) {
            still << toPicture(at, size);
            continue;
        }
        const auto colour = static_cast<std::size_t>(
            std::clamp(length_px / longest_px * (kArrowColours - 1), 0.0, kArrowColours - 1.0));
        lines[colour] << QLineF(toPicture(at, size), toPicture(at + enlargement * moved, size));
    }
    painter.setPen(QPen(QColor(255, 255, 255, 130), 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawPoints(still.constData(), static_cast<int>(still.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        // The lower half of the map is too dark for a dark picture.
        const double share = 0.45 + 0.55 * static_cast<double>(i) / (kArrowColours - 1);
        painter.setPen(QPen(QColor(kRim), 3.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines[i]);
        painter.setPen(
            QPen(QColor::fromRgb(base::colourAt(base::cividis(), share)), 1.8, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines[i]);
    }
}

void CameraPicture::paintContacts(QPainter& painter, const QSizeF& size) const {
    const QFontMetricsF metrics(font);
    const QFont large = base::sized(font, 1.2);
    painter.setFont(large);
    for (const FollowedContact& followed : shown.contacts) {
        if (followed.event == ContactEvent::ends)
            continue;
        const vision::CameraContact& contact = followed.contact;
        const QColor colour = base::identityColour(std::max(1, contact.id), true);
        QPolygonF outline;
        for (const auto& corner : contact.contour_px)
            outline << toPicture(pointOf(corner), size);
        const bool isBumped = bumped != 0 && bumped == contact.id && bumpFade > 0.0;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(kRim, 4.5));
        painter.drawPolygon(outline);
        painter.setPen(QPen(colour, isBumped ? 4.0 : 2.2, followed.seen ? Qt::SolidLine : Qt::DashLine));
        painter.drawPolygon(outline);
        const QPointF centre_px = toPicture({contact.centre_px.x(), contact.centre_px.y()}, size);
        painter.setPen(QPen(kRim, 1.0));
        painter.setBrush(colour);
        painter.drawEllipse(centre_px, 4.0, 4.0);
        const QRectF box = outline.boundingRect();
        QString text = QString::number(contact.id);
        if (isBumped)
            text += QLatin1Char(' ') + tr("BUMP");
        else if (shown.carrier && shown.carrier->doing == pipeline::CarrierReport::Doing::follows &&
                 shown.carrier->contact == contact.id)
            text += QLatin1Char(' ') + tr("followed");
        // A labelled box: bare digits are hard to read on the patterned skin.
        QRectF label(QPointF(box.right() + 0.3 * metrics.height(), box.top() - 0.3 * metrics.height()),
                     base::badgeSize(large, text));
        if (box.intersects(QRectF(QPointF(), size))) { // if any of it is visible
            label.moveRight(std::min(label.right(), size.width() - 2.0));
            label.moveTop(std::clamp(label.top(), 2.0, std::max(2.0, size.height() - label.height() - 2.0)));
        }
        const QRectF rim = label.adjusted(-1.5, -1.5, 1.5, 1.5);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kRim);
        painter.drawRoundedRect(rim, 0.2 * rim.height(), 0.2 * rim.height());
        base::paintBadge(painter, label, text, colour);
    }
    painter.setFont(font);
}

void CameraPicture::paintState(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    const base::StatusColours& colours = base::statusColours(palette);
    const QFontMetricsF metrics(font);
    const double margin = 0.5 * metrics.height();
    double right = size.width() - margin;
    const auto badge = [&](const QString& text, const QColor& colour) {
        const QSizeF extent = base::badgeSize(font, text);
        base::paintBadge(painter, {QPointF(right - extent.width(), margin), extent}, text, colour);
        right -= extent.width() + margin;
    };
    if (const QString text = base::provenanceText(provenance);
        !text.isEmpty() && !base::paintsScreen(painter))
        badge(text, base::provenanceColour(provenance, palette));
    if (paused)
        badge(tr("PAUSED"), colours.neutral);
    if (isEmpty())
        return;
    if (bumpFade > 0.0)
        badge(tr("BUMP"), colours.stop);
    if (!shown.usable && !shown.problem.empty()) {
        const QRectF line(margin, size.height() - 2.6 * metrics.height(), size.width() - 2.0 * margin,
                          2.2 * metrics.height());
        painter.setPen(Qt::white);
        painter.drawText(line, Qt::AlignCenter | Qt::TextWordWrap, QString::fromStdString(shown.problem));
    } else if (arrows && !shown.arrows.empty()) {
        const QRectF visible = imageRect(size) & QRectF(QPointF(), size);
        paintHalo(painter, {visible.left() + margin, visible.bottom() - margin},
                  tr("Displacement \u00d7 %1").arg(std::lround(enlargement)));
    }
}

QString CameraPicture::csv() const {
    QString text =
        QStringLiteral("frame,time_s,contact_id,u_px,v_px,x_m,y_m,z_m,dx_m,dy_m,dz_m,area_px,sd_m\n");
    const auto put = [&](double value, QChar separator) { text += base::csvNumber(value) + separator; };
    for (const FollowedContact& followed : shown.contacts) {
        const vision::CameraContact& contact = followed.contact;
        text += QString::number(shown.frame) + QLatin1Char(',');
        put(shown.time_s, u',');
        text += QString::number(contact.id) + QLatin1Char(',');
        for (const double value : contact.centre_px)
            put(value, u',');
        for (const double value : contact.p_Sensor_Centre_m)
            put(value, u',');
        for (const double value : followed.displacement_m())
            put(value, u',');
        put(contact.area_px, u',');
        put(contact.sd_m, u'\n');
    }
    return text;
}

} // namespace teleta::camera
