// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/scene/touch_scene.h"

#include <QPointF>
#include <QSizeF>
#include <QString>

#include <cstdint>
#include <optional>

namespace teleta::view3d {

/// A point of the picture, logical px from the top left.
struct PicturePoint {
    QPointF at;
    QSizeF size;      ///< of the whole picture
    double reach = 0; ///< how far away a thing may be
};

/// Describes the contact, of an array or a gel, whose foot is nearest to a point of the picture; empty: none
/// is within reach. Thread: GUI.
[[nodiscard]] QString wordsAt(const TouchScene& scene, const PicturePoint& point);

/// The number of the object whose outline or contact points are nearest; empty: none is within reach.
[[nodiscard]] std::optional<std::uint64_t> objectAt(const TouchScene& scene, const PicturePoint& point);

} // namespace teleta::view3d
