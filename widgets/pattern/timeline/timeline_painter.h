// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/comparison.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/timeline/timeline_curves.h"
#include "widgets/pattern/timeline/timeline_geometry.h"

#include <QFont>
#include <QPalette>

class QPainter;

namespace teleta::editor {

/// What the timeline shows at rest; the playhead and what the mouse draws go on top of it.
struct TimelineContent {
    const pattern::Pattern* pattern = nullptr;
    const TimelineCurves* curves = nullptr;
    const TimelineBands* bands = nullptr;      ///< of a long stretch, in place of the curves; may be null
    const TimelineCurves* reference = nullptr; ///< another pattern to compare with; may be null
    const TimelineBands* referenceBands = nullptr;
    QString referenceName;
    const pattern::Comparison* comparison = nullptr; ///< with the other pattern; may be null
    const Selection* selection = nullptr;
    std::optional<pattern::Span> loop;
    std::optional<std::size_t> currentLane; ///< where the keyboard is
    bool assumedMotors = true;
    bool handles = true;
};

/// Draws the timeline; returns how many handles of breakpoints it drew. Handles of a lane are left out where
/// they would lie on each other, except those that are selected.
int paintTimeline(QPainter& painter, const TimelineGeometry& geometry, const TimelineContent& content,
                  const QPalette& palette, const QFont& font);

/// The vertical line of the playhead with its flag on the ruler.
void paintPlayhead(QPainter& painter, const TimelineGeometry& geometry, double time_s,
                   const QPalette& palette);

/// "Ring, 3 turns" when it has no name of its own; translated.
[[nodiscard]] QString objectTitle(const pattern::PatternObject& object);
/// "Ring", "Sweep" ...; translated.
[[nodiscard]] QString formName(const pattern::ObjectForm& form);
/// Same colour for the same kind of object.
[[nodiscard]] QColor formColour(const pattern::ObjectForm& form, const QPalette& palette);

} // namespace teleta::editor
