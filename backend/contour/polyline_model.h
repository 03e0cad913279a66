// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"
#include "backend/contour/robust_fit.h"

#include <limits>
#include <vector>

namespace teleta::contour {

/// A chain of edges; parameters: the coordinates (x0, y0, x1, y1, ...) of its vertices, at least two and at
/// most kMostParameters / 2 of them. Distances are positive to the left of the chain. The first and last edge
/// of an open chain extend beyond its ends.
class PolylineModel : public RobustModel {
public:
    /// farthest: a vertex further from the origin on either axis makes every distance this.
    PolylineModel(const PointColumns& points, bool closed,
                  double farthest = std::numeric_limits<double>::infinity())
        : m_points(points)
        , m_closed(closed)
        , m_farthest(farthest) {}

    [[nodiscard]] const PointColumns& points() const override { return m_points; }
    void evaluate(At& at) const override;
    void equations(const At& at, const double* weights, const double* weightedResiduals,
                   StepEquations& equations) const override;
    [[nodiscard]] Eigen::MatrixXd jacobian(const At& at) const override;
    /// With these vertices, as many as the model may have, without a search.
    [[nodiscard]] RobustFit fitAt(const Eigen::VectorXd& vertices) const;

private:
    const PointColumns& m_points;
    bool m_closed;
    double m_farthest;
};

/// For each point the nearest edge and the place on it: index of the edge plus the share of its length.
/// Beyond the ends of an open chain the share is below 0 or above 1. vertices: coordinates of at least two,
/// at most kMostParameters numbers; for any other number of them every place is NaN. Thread: any (pure).
[[nodiscard]] std::vector<double> placesOnPolyline(std::span<const Point> points,
                                                   const Eigen::VectorXd& vertices, bool closed);

/// The same as the way from the first vertex, in units of the size. vertices: as there; otherwise every way
/// is NaN. Thread: any (pure).
[[nodiscard]] std::vector<double> waysOnPolyline(std::span<const Point> points,
                                                 const Eigen::VectorXd& vertices, bool closed);

[[nodiscard]] double polylineLength(const Eigen::VectorXd& vertices, bool closed);

[[nodiscard]] std::vector<Point> toVertices(const Eigen::VectorXd& coordinates);

/// First guesses of the vertices of an ordered contour. The contour is divided into runs of points so that
/// the sum of squared distances from the total-least-squares line of each run is minimal (exact, by dynamic
/// programming); the lines of neighbouring runs intersect in the vertices.
class EdgeRuns {
public:
    /// maximumEdges: the largest number of edges that vertices() will be asked for.
    EdgeRuns(std::span<const Point> points, bool closed, std::size_t maximumEdges);

    [[nodiscard]] std::size_t maximumEdges() const { return m_maximumEdges; }
    /// Least sum of squared distances of the points from the lines of this many edges, where one more run may
    /// leave an outlier out. edges: at most maximumEdges().
    [[nodiscard]] double leastSquares(std::size_t edges) const;
    /// Coordinates of the vertices of a chain with this number of edges: as many vertices when closed, one
    /// more when open. edges: 1 (open) or 3 (closed) to maximumEdges().
    [[nodiscard]] Eigen::VectorXd vertices(std::size_t edges) const;

private:
    struct Line {
        Point middle;
        Point direction;
    };
    struct Division {
        std::size_t width = 0;        ///< of a row
        std::vector<double> cost;     ///< (end, runs): least cost of the first `end` points in `runs` runs
        std::vector<double> previous; ///< where the last of these runs begins
    };
    void measureRuns();
    void divide(std::size_t edges);
    [[nodiscard]] Line line(std::size_t begin, std::size_t end) const;
    [[nodiscard]] std::vector<std::size_t> starts(std::size_t edges) const;

    std::size_t m_count;
    bool m_closed;
    std::size_t m_maximumEdges;
    std::vector<Point> m_points;
    std::size_t m_stride = 0;    ///< of m_costs
    std::vector<double> m_costs; ///< (end, begin) of runs
    Division m_division;
};

} // namespace teleta::contour
