// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/contour_order.h"
#include "backend/contour/curve_models.h"
#include "backend/contour/model_evidence.h"
#include "backend/contour/shape_recogniser.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// One explanation of a contour.
struct ShapeCandidate {
    Shape shape = Shape::unknown;
    double logWeight = 0.0; ///< log evidence plus log prior
    RobustFit fit;
    Evidence judged;
    std::vector<Point> vertices; ///< in units of the size, of shapes that have vertices
    std::optional<CurvedLine> circle;
};

/// All explanations listed in shape_recogniser.h except the point; at least one (scatter).
struct ShapeCandidates {
    std::vector<ShapeCandidate> all;
    bool closed = false; ///< the contour returns to its start, as given or as detected
};

/// Fits every explanation to a contour. contour: at least two different points. closed: empty to detect it.
/// Thread: any (pure).
[[nodiscard]] ShapeCandidates explain(const PreparedContour& contour, std::optional<bool> closed);

} // namespace teleta::contour
