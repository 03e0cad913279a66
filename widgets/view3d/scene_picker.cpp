// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene_picker.h"

#include "widgets/view3d/overlay_maker.h"

#include <algorithm>
#include <cmath>

namespace teleta::view3d {

namespace {

/// In px; empty: behind the camera.
std::optional<QPointF> pixelOf(const TouchScene& scene, const Eigen::Vector3d& p_World,
                               const PicturePoint& point) {
    const auto place = placeInPicture(*scene.renderer(), p_World);
    if (!place)
        return {};
    return QPointF(place->x() * point.size.width(), place->y() * point.size.height());
}

double length(const QPointF& way) {
    return std::hypot(way.x(), way.y());
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF way = b - a;
    const double square = QPointF::dotProduct(way, way);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(p - a, way) / square, 0.0, 1.0) : 0.0;
    return length(p - (a + share * way));
}

} // namespace

QString wordsAt(const TouchScene& scene, const PicturePoint& point) {
    double nearest_px = point.reach;
    const auto isNearer = [&](const Eigen::Vector3d& p_World_Foot) {
        const auto foot = pixelOf(scene, p_World_Foot, point);
        const double distance_px = foot ? length(*foot - point.at) : nearest_px;
        if (!(distance_px < nearest_px))
            return false;
        nearest_px = distance_px;
        return true;
    };
    QString words;
    for (const ContactMark& mark : scene.marks())
        if (isNearer(scene.toWorld(mark.p_Sensor_Foot)))
            words = wordsFor(mark.contact, QString::fromStdString(scene.snapshot().loadUnit));
    for (const GelMark& mark : scene.gel().marks())
        if (isNearer(scene.gel().X_World_Sensor() * mark.p_Sensor_Foot))
            words = mark.words.all;
    return words;
}

std::optional<std::uint64_t> objectAt(const TouchScene& scene, const PicturePoint& point) {
    std::optional<std::uint64_t> nearest;
    double nearest_px = point.reach;
    const auto take = [&](double distance_px, const DrawnObject& object) {
        if (distance_px < nearest_px) {
            nearest_px = distance_px;
            nearest = object.number;
        }
    };
    for (const DrawnObject& object : scene.objects().objects()) {
        for (const Eigen::Vector3d& p : object.points_m)
            if (const auto at = pixelOf(scene, p, point))
                take(length(*at - point.at), object);
        std::optional<QPointF> before;
        for (const Eigen::Vector3d& p : object.curve_m) {
            const auto at = pixelOf(scene, p, point);
            if (at && before)
                take(distanceToSegment(point.at, *before, *at), object);
            before = at;
        }
    }
    return nearest;
}

} // namespace teleta::view3d
