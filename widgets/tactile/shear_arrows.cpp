// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/shear_arrows.h"

#include "widgets/tactile/heatmap_ink.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace teleta::tactile {

namespace {

constexpr double kRoomForShear = 6.0;  ///< px
constexpr double kLargestHead = 12.0;  ///< px
constexpr double kShortestArrow = 2.0; ///< px

/// Calls visit(taxel) for each taxel of a contact.
template <typename Visit>
void eachTouched(const pipeline::TouchSnapshot& snapshot, Visit visit) {
    for (std::size_t taxel = 0; taxel < snapshot.labels.size(); ++taxel)
        if (snapshot.labels[taxel] > 0)
            visit(taxel);
}

} // namespace

bool hasRoomForShear(const HeatmapLayout& layout) {
    return layout.taxelSide() >= kRoomForShear;
}

void drawShearArrow(QPainter& painter, const QPointF& from, const QPointF& to, double head) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (!(length > 0.0))
        return;
    const QPointF along = way / length;
    const QPointF across(-along.y(), along.x());
    const double size = std::min(head, 0.6 * length);
    painter.drawLine(from, to);
    painter.drawLine(to, to - along * size + across * (0.6 * size));
    painter.drawLine(to, to - along * size - across * (0.6 * size));
}

double largestShear(const pipeline::TouchSnapshot& snapshot) {
    double largest = 0.0;
    eachTouched(snapshot, [&](std::size_t taxel) {
        largest = std::max(
            largest, static_cast<double>(std::hypot(snapshot.shearX_N[taxel], snapshot.shearY_N[taxel])));
    });
    return largest;
}

void paintShear(QPainter& painter, const HeatmapLayout& layout, const HeatmapContent& content) {
    if (!content.hasShear() || !hasRoomForShear(layout) || !(content.shearTop > 0.0))
        return;
    const pipeline::TouchSnapshot& snapshot = content.snapshot;
    const auto columns = static_cast<std::size_t>(snapshot.layout.grid().columns);
    const double scale = layout.taxelSide() / content.shearTop;
    const double width = std::clamp(0.08 * layout.taxelSide(), 1.0, 3.0);
    for (const bool isCasing : {true, false}) {
        painter.setPen(QPen(isCasing ? kCasing : kMark, isCasing ? width + 2.5 : width, Qt::SolidLine,
                            Qt::RoundCap, Qt::RoundJoin));
        eachTouched(snapshot, [&](std::size_t taxel) {
            const QPointF middle =
                layout.taxelRect({static_cast<int>(taxel / columns), static_cast<int>(taxel % columns)})
                    .center();
            // y of {s} points up.
            const QPointF way(scale * static_cast<double>(snapshot.shearX_N[taxel]),
                              -scale * static_cast<double>(snapshot.shearY_N[taxel]));
            if (std::hypot(way.x(), way.y()) >= kShortestArrow && layout.visible().contains(middle))
                drawShearArrow(painter, middle - 0.5 * way, middle + 0.5 * way,
                               std::min(0.35 * layout.taxelSide(), kLargestHead));
        });
    }
}

} // namespace teleta::tactile
