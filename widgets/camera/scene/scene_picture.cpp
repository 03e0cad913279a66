// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/scene/scene_picture.h"

#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <memory>

namespace teleta::camera {

namespace {

/// Over a picture that is too old; light text on it is readable whatever the picture shows.
constexpr QColor kDimmed(0, 0, 0, 170);
/// Larger pixels are shown as they are.
constexpr double kSmoothUpTo = 6.0;

} // namespace

QImage ScenePicture::shared() const {
    if (isEmpty())
        return {};
    auto* kept = new std::shared_ptr<const std::uint8_t>(image.pixels);
    return {image.pixels.get(),
            image.width_px,
            image.height_px,
            3 * static_cast<qsizetype>(image.width_px),
            QImage::Format_RGB888,
            [](void* pixels) { delete static_cast<std::shared_ptr<const std::uint8_t>*>(pixels); },
            kept};
}

double ScenePicture::captionHeight(const QFont& font) {
    return 1.5 * QFontMetricsF(font).height();
}

QRectF ScenePicture::imageRect(const QSizeF& size) const {
    const QRectF room =
        QRectF(QPointF(), size).adjusted(0.0, std::min(captionHeight(font), size.height()), 0.0, 0.0);
    if (isEmpty())
        return room;
    QRectF place(QPointF(), QSizeF(image.width_px, image.height_px).scaled(room.size(), Qt::KeepAspectRatio));
    place.moveCenter(room.center());
    return place;
}

void ScenePicture::paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    painter.save();
    painter.setFont(font);
    painter.setClipRect(QRectF(QPointF(), size));
    const QRectF room = imageRect(size);
    paintCaption(painter, QRectF(0.0, 0.0, size.width(), captionHeight(font)), palette);
    if (!isEmpty()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, room.width() < kSmoothUpTo * image.width_px);
        // QPainter scales three bytes a pixel at half the speed of four; the conversion is a tenth of that.
        painter.drawImage(room, shared().convertToFormat(QImage::Format_RGB32));
        if (!problem.isEmpty())
            painter.fillRect(room, kDimmed);
    }
    if (!problem.isEmpty())
        paintProblem(painter, room, palette);
    painter.restore();
}

void ScenePicture::paintAlone(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
    painter.save();
    painter.setFont(font);
    const QRectF all(QPointF(), size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!isEmpty())
        painter.drawImage(all, shared());
    const double margin = 0.5 * QFontMetricsF(font).height();
    const QRectF line(margin, margin, size.width() - 2.0 * margin, 1.5 * QFontMetricsF(font).height());
    (void)base::paintProvenance(painter, line, provenance, palette, margin);
    painter.restore();
}

void ScenePicture::paintCaption(QPainter& painter, const QRectF& line, const QPalette& palette) const {
    const QFontMetricsF metrics(font);
    const double margin = 0.4 * metrics.height();
    const double side = 0.6 * metrics.height();
    QRectF left = line.adjusted(margin, 0.0, -margin, 0.0);
    base::paintStatusGlyph(painter, QRectF(left.left(), left.center().y() - 0.5 * side, side, side), state,
                           palette);
    left.setLeft(left.left() + side + margin);
    const QFont strong = base::bold(font);
    const QFontMetricsF strongMetrics(strong);
    const double least = std::min(strongMetrics.horizontalAdvance(name), 0.4 * left.width());
    QStringList shown = numbers;
    const auto text = [&shown] { return shown.join(QStringLiteral("  ")); };
    while (!shown.isEmpty() && base::tabularWidth(metrics, text()) > left.width() - least - margin)
        shown.removeFirst();
    painter.setPen(palette.color(QPalette::PlaceholderText));
    base::drawTabularText(painter, left, Qt::AlignRight | Qt::AlignVCenter, text());
    painter.setFont(strong);
    painter.setPen(palette.color(QPalette::Text));
    const double room = left.width() - (shown.isEmpty() ? 0.0 : base::tabularWidth(metrics, text()) + margin);
    painter.drawText(left, Qt::AlignLeft | Qt::AlignVCenter,
                     strongMetrics.elidedText(name, Qt::ElideMiddle, room));
    painter.setFont(font);
}

void ScenePicture::paintProblem(QPainter& painter, const QRectF& room, const QPalette& palette) const {
    const QFont large = base::bold(base::sized(font, base::kTitleText));
    const double margin = QFontMetricsF(font).height();
    const QRectF inside = room.adjusted(margin, 0.0, -margin, 0.0);
    const int flags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    const QSizeF first = QFontMetricsF(large).boundingRect(inside, flags, problem).size();
    const QSizeF second =
        reason.isEmpty() ? QSizeF() : QFontMetricsF(font).boundingRect(inside, flags, reason).size();
    const double gap = reason.isEmpty() ? 0.0 : 0.25 * margin;
    QRectF at = inside;
    at.setTop(std::max(room.top(), room.center().y() - 0.5 * (first.height() + gap + second.height())));
    const QColor colour = isEmpty() ? palette.color(QPalette::PlaceholderText) : QColor(Qt::white);
    painter.setPen(colour);
    painter.setFont(large);
    painter.drawText(at, flags, problem);
    painter.setFont(font);
    at.setTop(at.top() + first.height() + gap);
    painter.drawText(at, flags, reason);
}

} // namespace teleta::camera
