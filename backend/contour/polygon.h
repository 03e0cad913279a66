// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/model_evidence.h"
#include "backend/contour/point.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// Vertices of a contour. Edge i runs from vertex i to the next one; a closed contour has as many edges as
/// vertices and an open one, whose first and last vertex are its ends, one less.
struct Polygon {
    std::vector<Point> vertices_m; ///< in the order of exploration
    bool closed = false;
    double rms_m = 0.0;       ///< distance of the points from the edges, outliers left out
    std::size_t outliers = 0; ///< points that belong to no edge

    [[nodiscard]] std::size_t edges() const {
        return closed ? vertices_m.size() : vertices_m.size() - std::min<std::size_t>(1, vertices_m.size());
    }
};

/// Finds the vertices and edges of a contour, a polygon or a chain of edges of either direction.
/// As in the paper, lines through neighbouring points intersect in a vertex, and where the intersection jumps
/// the next vertex begins. To hold against noise, the lines are fitted to runs of points (EdgeRuns), the
/// vertices are refined by robust least squares of all points together, and the number of edges, at most
/// kMaximumEdges, is the one with the largest evidence (model_evidence.h). A contour traversed several times
/// is merged first; single outliers are left out. closed: empty to find out by itself. One point or none, or
/// points that are all one: no vertices. Empty when a coordinate is not usable. Thread: any (pure). Source:
/// TeleTA, section 3.
[[nodiscard]] std::optional<Polygon> findPolygon(std::span<const Point> points_m,
                                                 std::optional<bool> closed = {});

inline constexpr std::size_t kMaximumEdges = 16;

/// One chain of edges fitted to a prepared contour (units of its size).
struct ChainFit {
    RobustFit fit; ///< parameters: coordinates of the vertices
    Evidence evidence;
    std::size_t edges = 0;
    bool closed = false;
};

/// The two ends of an open chain are known to one spacing: its evidence is divided by the squared number of
/// points. Chains of 1 (open) or 3 (closed) and more edges, each with its best vertices, until more edges
/// have not helped for three times. points: in order, without spikes for the first guess; all of them are
/// fitted.
[[nodiscard]] std::vector<ChainFit> fitChains(std::span<const Point> points, bool closed,
                                              std::size_t maximumEdges);

/// Closed chain of the given vertices as first guess.
[[nodiscard]] ChainFit fitClosedChain(std::span<const Point> points, const Eigen::VectorXd& start);

} // namespace teleta::contour
