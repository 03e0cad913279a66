// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/pattern.h"

#include <QPalette>
#include <QRectF>

#include <array>
#include <cstddef>

class QPainter;

namespace teleta::study {

/// Contents of a pattern's picture, computed from the pattern.
struct PatternDiagram {
    static constexpr std::size_t kColumns = 96;

    core::Intensities strongest{}; ///< of each tactor over the whole pattern
    std::array<int, core::kTactors>
        turn{}; ///< which tactors begin first: 1, 2, ..; all 0 when they begin together
    std::array<core::Intensities, kColumns> course{}; ///< over span_s, evenly
    double span_s = 0.0;                              ///< what the course covers
};

/// span_s: shown length, > 0; shorter patterns are padded, so that pictures with the same span can be
/// compared. Thread: any (pure).
[[nodiscard]] PatternDiagram diagramOf(const pattern::Pattern& pattern, double span_s);

/// The arm in cross-section with six tactors around it, tactor 1 on top, rising numbers counter-clockwise:
/// each filled by its peak intensity, with the order of its onset. Below, intensity over time: one curve if
/// all tactors do the same, otherwise a lane for each active one.
void paintDiagram(QPainter& painter, const QRectF& rect, const PatternDiagram& diagram,
                  const QPalette& palette);

} // namespace teleta::study
