// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/edit/comparison.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/timeline/timeline_curves.h"
#include "widgets/pattern/timeline/timeline_geometry.h"

#include <QFont>
#include <QPalette>

class QPainter;

namespace teleta::pattern {

/// Static content of the timeline; playhead and selection box are drawn on top of it.
struct TimelineContent {
    const Pattern* pattern = nullptr;
    const TimelineCurves* curves = nullptr;
    const TimelineBands* bands = nullptr;      ///< for a long span, instead of the curves; may be null
    const TimelineCurves* reference = nullptr; ///< pattern of the comparison; may be null
    const TimelineBands* referenceBands = nullptr;
    QString referenceName = {};
    const Comparison* comparison = nullptr; ///< with the other pattern; may be null
    const Selection* selection = nullptr;
    std::optional<Span> loop = {};
    std::optional<std::size_t> currentLane = {}; ///< lane with the keyboard focus
    bool assumedMotors = true;
};

/// Draws the timeline and returns the number of handles of breakpoints drawn. The handles of a lane are left
/// out where they would overlap, except for selected ones.
int paintTimeline(QPainter& painter, const TimelineGeometry& geometry, const TimelineContent& content,
                  const QPalette& palette, const QFont& font);

/// Draws the line of the playhead with its flag on the ruler.
void paintPlayhead(QPainter& painter, const TimelineGeometry& geometry, double time_s,
                   const QPalette& palette);

/// The name of an object or, without a name, a description such as "Ring, 3 turns"; translated.
[[nodiscard]] QString objectTitle(const PatternObject& object);
/// "Ring", "Sweep" ...; translated.
[[nodiscard]] QString formName(const ObjectForm& form);
/// Colour of a kind of object.
[[nodiscard]] QColor formColour(const ObjectForm& form, const QPalette& palette);

} // namespace teleta::pattern
