// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/view3d/scene/scene_colours.h"

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QSizeF>
#include <QString>

#include <array>
#include <optional>
#include <vector>

class QPainter;

namespace teleta::view3d {

/// A text beside a point in the picture.
struct OverlayLabel {
    QPointF place; ///< position of the point, as shares of the picture's width and height from the top left
    QString text;
    QColor colour;
    bool boxed = false;  ///< on a small card with a dot in its colour; cards do not overlap
    bool beside = false; ///< a card at the side of the point, tied to it by a line: it hides nothing there
};

/// A line below the scene.
struct LegendLine {
    enum class Arrow {
        none,
        straight, ///< beside the text, as forces are drawn
        turned,   ///< likewise, as moments are
    };
    QString text;
    Arrow arrow = Arrow::none;
};

/// Everything written over the 3-D picture. A value, so that a saved picture keeps its own.
struct OverlayContent {
    QFont font;
    SceneColours colours;
    base::Provenance provenance = base::Provenance::live;
    QString emptyText;      ///< shown instead of everything else; empty: there are data
    double loadRange = 0.0; ///< end of the colour bar; 0: no bar
    QString loadUnit;
    std::vector<LegendLine> legend;
    std::vector<OverlayLabel> labels;
    std::optional<QPointF> array; ///< middle of the array, as a label's place: cards go away from it
    bool orientationShown = false;
    /// Directions x, y, z on the screen: right, up, toward the viewer.
    std::array<std::array<double, 3>, 3> orientation{};
};

/// "x", "y", "z".
[[nodiscard]] inline QString axisName(std::size_t axis) {
    return QChar(static_cast<char16_t>(u'x' + axis));
}

void paintOverlay(QPainter& painter, const QSizeF& size, const OverlayContent& content);

} // namespace teleta::view3d
