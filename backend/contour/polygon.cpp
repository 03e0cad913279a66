// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polygon.h"

#include "backend/contour/contour_order.h"
#include "backend/contour/polyline_model.h"

#include <algorithm>
#include <cmath>

namespace teleta::contour {

namespace {

constexpr std::size_t kPatience = 3;
constexpr double kShortestSpacing = 1e-3;
constexpr double kFarthestVertex = 1.5; ///< from the centre of the contour

/// Moves the ends of an open chain to the outermost projections of its points.
void trimEnds(std::span<const Point> points, const Evidence& judged, Eigen::VectorXd& vertices) {
    const Eigen::Index last = vertices.size() / 2 - 1;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const std::vector<double> places = placesOnPolyline(points, vertices, false);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!judged.outliers[i]) {
            low = std::min(low, places[i]);
            high = std::max(high, places[i]);
        }
    const auto place = [&](double along) -> Point {
        const auto edge = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(along)), 0, last - 1);
        const Point a = vertices.segment<2>(2 * edge);
        const Point b = vertices.segment<2>(2 * edge + 2);
        return a + (along - static_cast<double>(edge)) * (b - a);
    };
    if (low >= high)
        return;
    const Point first = low < 1.0 ? place(low) : Point(vertices.head<2>());
    const Point end = high > static_cast<double>(last - 1) ? place(high) : Point(vertices.tail<2>());
    vertices.head<2>() = first;
    vertices.tail<2>() = end;
}

ChainFit fitChain(std::span<const Point> points, const PointColumns& columns, const Eigen::VectorXd& start,
                  bool closed) {
    // Otherwise a vertex that few points determine could drift away along its edge.
    const PolylineModel model(columns, closed, kFarthestVertex);
    ChainFit chain;
    chain.fit = fitRobustly(model, start);
    chain.closed = closed;
    chain.edges = static_cast<std::size_t>(start.size()) / 2 - (closed ? 0 : 1);
    if (!closed) {
        trimEnds(points, judge(chain.fit.residuals, 1.0), chain.fit.parameters);
        const double scale = chain.fit.scale;
        chain.fit = model.fitAt(chain.fit.parameters);
        chain.fit.scale = scale;
    }
    // A vertex between two points without an edge, and the end of an open chain, can move by one spacing.
    const double length = polylineLength(chain.fit.parameters, closed);
    const double spacing = length / static_cast<double>(points.size());
    chain.evidence = evidence(chain.fit, length, {.freedom = std::clamp(spacing, kShortestSpacing, 1.0)});
    return chain;
}

} // namespace

ChainFitter::ChainFitter(std::span<const Point> points, std::span<const Point> ordered, bool closed,
                         std::size_t maximumEdges)
    : m_points(points)
    , m_columns(points)
    , m_closed(closed)
    , m_runs(withoutSpikes(ordered, closed), closed, maximumEdges) {
}

std::vector<ChainFit> ChainFitter::fitFrom(std::size_t edges, const Rival& rival) const {
    std::vector<ChainFit> chains;
    double best = kImpossibleEvidence;
    std::size_t worse = 0;
    for (; edges <= mostEdges() && worse < kPatience; ++edges) {
        ++worse;
        const std::size_t parameters = 2 * edges + (m_closed ? 0 : 2);
        if (evidenceToExpect(m_points.size(), parameters, m_runs.leastSquares(edges), rival.length) <
            rival.logEvidence)
            continue;
        chains.push_back(fitChain(m_points, m_columns, start(edges), m_closed));
        if (chains.back().evidence.logEvidence > best) {
            best = chains.back().evidence.logEvidence;
            worse = 0;
        }
    }
    return chains;
}

RobustFit fitClosedChain(std::span<const Point> points, const std::vector<Eigen::VectorXd>& starts) {
    const PointColumns columns(points);
    return fitBest(PolylineModel(columns, true, kFarthestVertex), {starts.begin(), starts.end()},
                   [](const Eigen::VectorXd& vertices) { return polylineLength(vertices, true); });
}

std::optional<Polygon> findPolygon(std::span<const Point> points_m, std::optional<bool> closed) {
    if (!areUsable(points_m))
        return std::nullopt;
    const PreparedContour contour = prepare(points_m);
    Polygon polygon;
    if (contour.points.size() < 2 || contour.extent_m == 0.0)
        return polygon;

    const std::vector<Point> ordered = mergedLaps(contour.points);
    const bool isClosed = closed.value_or(returnsToItsStart(ordered));
    const auto fitted = [&](bool asClosed) {
        const ChainFitter fitter(ordered, ordered, asClosed, kMaximumEdges);
        return fitter.fitFrom(fitter.fewestEdges());
    };
    std::vector<ChainFit> chains = fitted(isClosed);
    if (chains.empty())
        chains = fitted(false);
    const auto best = std::ranges::max_element(
        chains, {}, [](const ChainFit& chain) { return chain.evidence.logEvidence; });
    const PointColumns columns(ordered);
    best->fit = polished(PolylineModel(columns, best->closed, kFarthestVertex), best->fit);
    polygon.closed = best->closed;
    polygon.rms_m = contour.size_m * rmsOfInliers(best->fit, best->evidence);
    polygon.outliers = contour.rejected + best->evidence.outlierCount();
    for (const Point& p : toVertices(best->fit.parameters))
        polygon.vertices_m.push_back(contour.toMetres(p));
    return polygon;
}

} // namespace teleta::contour
