// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/model_evidence.h"
#include "backend/contour/point.h"
#include "backend/contour/polyline_model.h"

#include <optional>
#include <vector>

namespace teleta::contour {

/// Vertices of a contour. Edge i runs from vertex i to the next one. A closed contour has as many edges as
/// vertices, an open one (whose first and last vertex are its ends) one less.
struct Polygon {
    std::vector<Point> vertices_m; ///< in the order of exploration
    bool closed = false;
    double rms_m = 0.0;       ///< root mean square distance of the points from the edges, without outliers
    std::size_t outliers = 0; ///< number of points that belong to no edge

    [[nodiscard]] std::size_t edges() const {
        return closed ? vertices_m.size() : vertices_m.size() - std::min<std::size_t>(1, vertices_m.size());
    }
};

/// Finds the vertices of a contour that is a polygon or an open chain of edges, explored in either direction.
/// As in the paper, lines through neighbouring points intersect in a vertex, and where the intersection jumps
/// the next vertex begins. For robustness against noise the lines are fitted to runs of points (EdgeRuns),
/// all vertices are refined together by robust least squares, and the number of edges, at most kMaximumEdges,
/// is the one with the largest evidence (model_evidence.h). Several laps are merged first; single outliers
/// are left out. closed: empty to detect it. No vertices when there are fewer than two points or all are in
/// one place. Empty when a coordinate is unusable. Thread: any (pure). Source: TeleTA, section 3.
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

/// Another curve through the same points.
struct Rival {
    double logEvidence = kImpossibleEvidence;
    double length = 1.0; ///< of the part that was touched
};

/// Fits chains of edges to a contour. The ends of an open chain are known only to one spacing, so its
/// evidence is divided by the squared number of points. Thread: one at a time.
class ChainFitter {
public:
    /// points: all, in any order, kept by the caller; ordered: the same in the order of exploration, for the
    /// first guess, which leaves spikes out.
    ChainFitter(std::span<const Point> points, std::span<const Point> ordered, bool closed,
                std::size_t maximumEdges);

    [[nodiscard]] std::size_t fewestEdges() const { return m_closed ? 3 : 1; }
    [[nodiscard]] std::size_t mostEdges() const { return m_runs.maximumEdges(); }
    /// Coordinates of the vertices of the first guess. edges: fewestEdges() to mostEdges().
    [[nodiscard]] Eigen::VectorXd start(std::size_t edges) const { return m_runs.vertices(edges); }
    /// Fits chains of this many and more edges until three more edges in a row have not raised the evidence.
    /// Chains that are not expected to come up to a rival are left out, and do not raise it.
    [[nodiscard]] std::vector<ChainFit> fitFrom(std::size_t edges, const Rival& rival = {}) const;

private:
    std::span<const Point> m_points;
    PointColumns m_columns;
    bool m_closed;
    EdgeRuns m_runs;
};

/// Fits a closed chain. starts: coordinates of the vertices of first guesses, as many of each.
[[nodiscard]] RobustFit fitClosedChain(std::span<const Point> points,
                                       const std::vector<Eigen::VectorXd>& starts);

} // namespace teleta::contour
