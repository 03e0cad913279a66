// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/pattern.h"

#include <QPalette>
#include <QRectF>

#include <array>
#include <cstddef>

class QPainter;

namespace teleta::studyview {

/// What the picture of a pattern shows, taken from the pattern itself.
struct PatternDiagram {
    static constexpr std::size_t kColumns = 96;

    core::Intensities strongest{}; ///< of each tactor over the whole pattern
    std::array<int, core::kTactors>
        turn{}; ///< which tactors begin first: 1, 2, ..; all 0 when they begin together
    std::array<core::Intensities, kColumns> course{}; ///< over span_s, evenly
    double span_s = 0.0;                              ///< what the course covers
};

/// span_s: shown length, > 0; a shorter pattern is off for the rest of it, so that pictures with the same
/// span can be compared. Thread: any (pure).
[[nodiscard]] PatternDiagram diagramOf(const pattern::Pattern& pattern, double span_s);

/// The arm in cross-section with six tactors around it, tactor 1 on top, rising numbers counter-clockwise:
/// each filled as strongly as it ever vibrates, with the turn in which it begins. Below, intensity over time:
/// one curve for tactors that all do the same, otherwise a lane for each that is on.
void paintDiagram(QPainter& painter, const QRectF& rect, const PatternDiagram& diagram,
                  const QPalette& palette);

} // namespace teleta::studyview
