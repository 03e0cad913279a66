// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/tactile/heatmap_content.h"
#include "widgets/tactile/heatmap_layout.h"

class QPainter;

namespace teleta::tactile {

/// Draws the force along the surface on each taxel of a contact as an arrow whose middle is its centre:
/// HeatmapContent::shearTop is as long as a taxel is wide. Thread: GUI.
void paintShear(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content);

/// Whether taxels are large enough for arrows.
[[nodiscard]] bool hasRoomForShear(const HeatmapLayout& layout);

/// An arrow with the painter's pen; a head of at most this size.
void drawShearArrow(QPainter& painter, const QPointF& from, const QPointF& to, double head);

/// The largest shear on a taxel of a contact; 0: there is none.
[[nodiscard]] double largestShear(const pipeline::TouchSnapshot& snapshot);

} // namespace teleta::tactile
