// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/contour_order.h"
#include "backend/contour/curve_models.h"
#include "backend/contour/model_evidence.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::contour {

/// What may have made the points of a contour: first the named shapes, then what is none of them.
enum class Model {
    line,
    circle,
    arc,
    triangle,
    rectangle,
    partOfTriangle,  ///< the rest was not touched
    partOfRectangle, ///< the same
    ellipse,
    regularPolygon, ///< with five or six corners
    chain,          ///< open or closed, any number of edges
    roughly,        ///< a curve that follows a named shape only roughly
    walk,           ///< a random walk
    scatter,        ///< points without any order or shape
};
inline constexpr std::size_t kModels = 13;

/// One explanation of a contour.
struct Explanation {
    Model model = Model::scatter; ///< circle, triangle and rectangle: whole ones and parts of them
    double logEvidence = kImpossibleEvidence;
    RobustFit fit{};
    Evidence judged{};
    std::vector<Point> vertices{}; ///< in units of the size, of models that have vertices
    std::optional<CurvedLine> circle{};
    double untouched = 0.0; ///< share of a circle, triangle or rectangle, see untouchedShare()
    bool everyEdge = true;  ///< every edge of a triangle or rectangle has a point that is not near its ends
};

/// All explanations of a contour; always one by scatter.
struct Explanations {
    std::vector<Explanation> all;
    bool closed = false; ///< the contour returns to its start, as given or as detected
};

/// Fits every model to a contour of at least two different points and computes its evidence: that of the
/// distances (evidence()) along the part of the curve that was touched, and that of the order of touch
/// (logEvidenceOfOrder()). Of three points only a line and what is no named shape. closed: empty to detect
/// it. Thread: any (pure).
[[nodiscard]] Explanations explain(const PreparedContour& contour, std::optional<bool> closed);

} // namespace teleta::contour
