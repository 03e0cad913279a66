// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/tactile/heatmap_content.h"
#include "widgets/tactile/heatmap_layout.h"

class QPainter;

namespace teleta::tactile {

/// Draws taxels that stand on no grid as discs in the colours of their loads, each as wide as the distance to
/// the next one. A dead taxel is an empty disc with a cross. Thread: GUI.
void paintDiscs(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content);

/// Draws a ring in the colour of its contact around each of them that is in one. width: of the ring.
void paintDiscRings(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content,
                    double width);

/// The middle of the upper edge of the highest disc of a contact, and of the lower edge of the lowest one.
struct DiscEnds {
    QPointF above, below;
};
[[nodiscard]] DiscEnds discEndsOf(const HeatmapLayout& layout, const HeatmapContent& content,
                                  const contact::Contact& contact);

} // namespace teleta::tactile
