// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/gel/gel_picture.h"

#include "backend/vision/gel/marker_rows.h"
#include "backend/vision/gel/slip_monitor.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/numbers/moment_unit.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/steady_estimate.h"
#include "widgets/base/theme.h"
#include "widgets/camera/picture_marks.h"

#include <QFontMetricsF>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::camera {

namespace {

using vision::GelContactState;

constexpr std::size_t kShearColours = 32;

QPointF pointOf(const Eigen::Vector2d& p) {
    return {p.x(), p.y()};
}

/// The lines of an arrow: shaft and head.
void addArrow(QList<QLineF>& lines, const QPointF& from, const QPointF& to) {
    const QLineF shaft(from, to);
    lines << shaft;
    const double head = std::min(7.0, 0.5 * shaft.length());
    for (const double turn : {150.0, -150.0}) {
        QLineF side(to, to + QPointF(head, 0.0));
        side.setAngle(shaft.angle() + turn);
        lines << side;
    }
}

/// Lines over the picture, readable on any grey.
void drawLines(QPainter& painter, const QList<QLineF>& lines, const QColor& colour) {
    painter.setPen(QPen(kRim, 3.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLines(lines);
    painter.setPen(QPen(colour, 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLines(lines);
}

/// Rows of CSV in a text.
class TextRows {
public:
    void integer(long long value) { put(QString::number(value)); }
    void number(std::optional<double> value) { put(base::csvNumber(value)); }
    void endRow() {
        text += QLatin1Char('\n');
        m_begins = true;
    }

    QString text;

private:
    void put(const QString& cell) {
        if (!m_begins)
            text += QLatin1Char(',');
        m_begins = false;
        text += cell;
    }
    bool m_begins = true;
};

} // namespace

double GelPicture::scale(const QSizeF& size) const {
    if (isEmpty())
        return 1.0;
    return std::min(size.width() / shown.image.width_px, size.height() / shown.image.height_px);
}

QRectF GelPicture::imageRect(const QSizeF& size) const {
    const QSizeF extent = scale(size) * QSizeF(shown.image.width_px, shown.image.height_px);
    return {QPointF(0.5 * (size.width() - extent.width()), 0.5 * (size.height() - extent.height())), extent};
}

QPointF GelPicture::toPicture(const QPointF& pixel, const QSizeF& size) const {
    // The centre of the upper left pixel is (0, 0).
    return imageRect(size).topLeft() + scale(size) * (pixel + QPointF(0.5, 0.5));
}

QPolygonF GelPicture::outlineOf(const GelContactState& contact, const QSizeF& size) const {
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : contact.outline_px)
        outline << toPicture(pointOf(corner), size);
    return outline;
}

int GelPicture::contactAt(const QPointF& point, const QSizeF& size) const {
    for (std::size_t i = 0; i < shown.contacts.size(); ++i)
        if (outlineOf(shown.contacts[i], size).containsPoint(point, Qt::OddEvenFill))
            return static_cast<int>(i);
    return -1;
}

QString GelPicture::slipText(const GelContactState& contact) {
    return contact.slipIndex ? tr("slip %1").arg(base::fixedDigits(contact.slipIndex, 2))
                             : tr("slip unknown");
}

QColor GelPicture::slipColour(const GelContactState& contact, bool onDark) {
    const base::StatusColours& colours = base::statusColours(base::designedPalette(onDark));
    if (!contact.slipIndex)
        return colours.neutral;
    return *contact.slipIndex >= vision::kSlipIndex            ? colours.lost
           : *contact.slipIndex >= vision::kIncipientSlipIndex ? colours.stale
                                                               : colours.live;
}

QString GelPicture::wordsFor(const GelContactState& contact) {
    const double turn_deg = contact.torsion_rad * 180.0 / M_PI;
    const double way_deg = std::atan2(contact.shearProxy_m.y(), contact.shearProxy_m.x()) * 180.0 / M_PI;
    QStringList lines;
    lines << tr("Contact %1").arg(contact.id);
    lines << tr("at %1, %2")
                 .arg(base::millimetres(contact.centre_m.x()), base::millimetres(contact.centre_m.y()));
    lines << tr("area %1 mm\u00b2").arg(base::fixedDigits(1e6 * contact.area_m2, 1));
    lines << tr("shear %1 at %2\u00b0")
                 .arg(base::millimetres(contact.shearProxy_m.norm()), base::fixedDigits(way_deg, 0));
    lines << tr("turned by %1\u00b0").arg(base::fixedDigits(turn_deg, 1));
    lines << (contact.slipIndex ? tr("slip index %1").arg(base::fixedDigits(contact.slipIndex, 2))
                                : tr("too few markers for a slip index"));
    return lines.join(QLatin1Char('\n'));
}

QString GelPicture::wordsFor(const pipeline::GelSnapshot& snapshot, std::size_t contact) {
    return (QStringList(wordsFor(snapshot.contacts[contact])) + loadTexts(snapshot, contact))
        .join(QLatin1Char('\n'));
}

QStringList GelPicture::loadTexts(const pipeline::GelSnapshot& snapshot, std::size_t contact) {
    static constexpr std::array kNames{QT_TR_NOOP("load %1"), QT_TR_NOOP("shear along x %1"),
                                       QT_TR_NOOP("shear along y %1"), QT_TR_NOOP("moment %1")};
    static_assert(kNames.size() == equilibration::kLoadColumns.size());
    QStringList texts;
    if (contact >= snapshot.loads.size())
        return texts;
    const auto& [loads, errors, extrapolated] = snapshot.loads[contact];
    for (std::size_t i = 0; i < snapshot.loadNames.size(); ++i) {
        const auto known = std::ranges::find(equilibration::kLoadColumns, snapshot.loadNames[i]);
        if (known == equilibration::kLoadColumns.end())
            continue;
        const double load = loads[static_cast<Eigen::Index>(i)];
        const double error = errors[static_cast<Eigen::Index>(i)];
        const base::MomentUnit unit = *known == "moment_nm"
                                          ? base::momentUnit(std::fmax(std::abs(load), error))
                                          : base::MomentUnit{1.0, QStringLiteral("N")};
        base::SteadyEstimate estimate;
        estimate.update(unit.perNm * load, unit.perNm * error);
        texts << tr(kNames.at(static_cast<std::size_t>(known - equilibration::kLoadColumns.begin())))
                     .arg(base::withUnit(estimate.text().trimmed(), unit.name));
        if (extrapolated)
            texts.back() += QStringLiteral(", ") + tr("extrapolated", "loads");
    }
    return texts;
}

GelPicture::Legend GelPicture::legend(const QSizeF& size) const {
    if (isEmpty() || !(shown.scale_m > 0.0))
        return {};
    const double perMetre_px = enlargement * scale(size) / shown.scale_m;
    const double most_m = std::min(120.0, 0.3 * imageRect(size).width()) / perMetre_px;
    const double decade_m = std::pow(10.0, std::floor(std::log10(most_m)));
    const double share = most_m / decade_m;
    const double length_m = decade_m * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
    return {length_m, length_m * perMetre_px};
}

void GelPicture::paint(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
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
        if (arrows && shown.usable)
            paintLegend(painter, size);
    }
    paintState(painter, size, palette);
    painter.restore();
}

void GelPicture::paintImage(QPainter& painter, const QSizeF& size) const {
    const core::GreyImage& image = shown.image;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale(size) < 6.0);
    painter.drawImage(imageRect(size), QImage(image.pixels.get(), image.width_px, image.height_px,
                                              image.width_px, QImage::Format_Grayscale8));
    if (!shown.usable && shown.hasReference())
        painter.fillRect(imageRect(size), QColor(0, 0, 0, 110));
}

void GelPicture::paintArrows(QPainter& painter, const QSizeF& size) const {
    double longest_m = 10.0 * kLeastArrow * shown.noise_m;
    for (const vision::GelMotion& motion : shown.motions)
        if (motion.found)
            longest_m = std::max(longest_m, motion.displacement_m.norm());
    std::array<QList<QLineF>, kShearColours> lines;
    QList<QPointF> lost;
    for (std::size_t i = 0; i < std::min(shown.markers.size(), shown.motions.size()); ++i) {
        const QPointF rest = pointOf(shown.markers[i].rest_px);
        const vision::GelMotion& motion = shown.motions[i];
        if (!motion.found) {
            lost << toPicture(rest, size);
            continue;
        }
        const double moved_m = motion.displacement_m.norm();
        if (!(moved_m >= kLeastArrow * shown.noise_m))
            continue;
        const double share = std::clamp(moved_m / longest_m, 0.0, 1.0);
        const auto colour = static_cast<std::size_t>(share * (kShearColours - 1));
        addArrow(lines[colour], toPicture(rest, size),
                 toPicture(rest + enlargement * (pointOf(motion.place_px) - rest), size));
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        // The lower half of the map is too dark for a dark picture.
        const double share = 0.45 + 0.55 * static_cast<double>(i) / (kShearColours - 1);
        drawLines(painter, lines[i], QColor::fromRgb(base::colourAt(base::cividis(), share)));
    }
    if (!shown.usable)
        return;
    // A cross where a marker was lost.
    QList<QLineF> crosses;
    constexpr double kArm_px = 4.0;
    for (const QPointF& at : lost)
        crosses << QLineF(at - QPointF(kArm_px, kArm_px), at + QPointF(kArm_px, kArm_px))
                << QLineF(at + QPointF(-kArm_px, kArm_px), at + QPointF(kArm_px, -kArm_px));
    drawLines(painter, crosses, base::statusColours(base::designedPalette(true)).lost);
}

void GelPicture::paintContacts(QPainter& painter, const QSizeF& size) const {
    const QFontMetricsF metrics(font);
    const QFont large = base::sized(font, 1.2);
    for (std::size_t i = 0; i < shown.contacts.size(); ++i) {
        const GelContactState& contact = shown.contacts[i];
        const QColor colour = base::identityColour(std::max(1, contact.id), true);
        const QPolygonF outline = outlineOf(contact, size);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(kRim, 4.5));
        painter.drawPolygon(outline);
        painter.setPen(QPen(colour, 2.2));
        painter.drawPolygon(outline);
        // Number, slip and load side by side on labelled boxes: bare digits are hard to read on the markers.
        const QString number = QString::number(contact.id);
        const QString slip = slipText(contact);
        painter.setFont(large);
        const QSizeF numberSize = base::badgeSize(large, number);
        const QSizeF slipSize = base::badgeSize(large, slip);
        const double gap = 0.2 * metrics.height();
        const QString load = loadTexts(shown, i).value(0);
        const QSizeF loadSize = load.isEmpty() ? QSizeF() : base::badgeSize(large, load);
        const double loadWidth = load.isEmpty() ? 0.0 : gap + loadSize.width();
        const QRectF box = outline.boundingRect();
        QRectF labels(QPointF(box.left(), box.top() - numberSize.height() - gap),
                      QSizeF(numberSize.width() + gap + slipSize.width() + loadWidth, numberSize.height()));
        labels.moveLeft(std::clamp(labels.left(), 2.0, std::max(2.0, size.width() - labels.width() - 2.0)));
        labels.moveTop(std::max(labels.top(), 2.0));
        const QRectF rim = labels.adjusted(-1.5, -1.5, 1.5, 1.5);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kRim);
        painter.drawRoundedRect(rim, 0.2 * rim.height(), 0.2 * rim.height());
        base::paintBadge(painter, {labels.topLeft(), numberSize}, number, colour);
        const QPointF slipAt = labels.topLeft() + QPointF(numberSize.width() + gap, 0.0);
        base::paintBadge(painter, {slipAt, slipSize}, slip, slipColour(contact));
        if (!load.isEmpty())
            base::paintBadge(painter, {slipAt + QPointF(slipSize.width() + gap, 0.0), loadSize}, load,
                             base::statusColours(base::designedPalette(true)).neutral);
        painter.setFont(font);
    }
}

void GelPicture::paintLegend(QPainter& painter, const QSizeF& size) const {
    const Legend shownAs = legend(size);
    if (!(shownAs.length_px > 0.0))
        return;
    const QFontMetricsF metrics(font);
    const double margin = 0.5 * metrics.height();
    const QPointF left = imageRect(size).bottomLeft() + QPointF(margin, -margin);
    const QPointF tail = left - QPointF(0.0, 0.4 * metrics.ascent());
    QList<QLineF> lines;
    addArrow(lines, tail, tail + QPointF(shownAs.length_px, 0.0));
    drawLines(painter, lines, Qt::white);
    paintHalo(painter, left + QPointF(shownAs.length_px + margin, 0.0),
              tr("%1 mm (enlarged %2 times)")
                  .arg(base::significantDigits(1e3 * shownAs.length_m, 2),
                       base::significantDigits(enlargement, 2)));
}

void GelPicture::paintState(QPainter& painter, const QSizeF& size, const QPalette& palette) const {
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
}

QString GelPicture::csv() const {
    TextRows rows;
    for (std::size_t i = 0; i < vision::kMarkerColumns.size(); ++i) {
        const std::string_view name = vision::kMarkerColumns[i];
        rows.text += (i > 0 ? QStringLiteral(",") : QString()) +
                     QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
    }
    rows.endRow();
    vision::writeMarkers(rows, static_cast<long long>(shown.frame), shown.time_s, shown.markers,
                         shown.motions);
    return rows.text;
}

} // namespace teleta::camera
