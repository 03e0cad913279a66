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
                  bool closed, bool roughly) {
    // Otherwise a vertex that few points determine could drift away along its edge.
    const PolylineModel model(columns, closed, kFarthestVertex);
    ChainFit chain;
    chain.fit = roughly ? fitRoughly(model, start) : fitRobustly(model, start);
    chain.closed = closed;
    chain.edges = static_cast<std::size_t>(start.size()) / 2 - (closed ? 0 : 1);
    if (!closed) {
        trimEnds(points, judge(chain.fit.residuals, 1.0), chain.fit.parameters);
        chain.fit = model.fitAt(chain.fit.parameters);
    }
    // A vertex between two points without an edge, and the end of an open chain, can move by one spacing.
    const double length = polylineLength(chain.fit.parameters, closed);
    const double spacing = length / static_cast<double>(points.size());
    chain.evidence = evidence(chain.fit, length, {.freedom = std::clamp(spacing, kShortestSpacing, 1.0)});
    return chain;
}

} // namespace

std::vector<ChainFit> fitChains(std::span<const Point> points, std::span<const Point> ordered, bool closed,
                                std::size_t maximumEdges, std::size_t roughEdges) {
    const PointColumns columns(points);
    const EdgeRuns runs(withoutSpikes(ordered, closed), closed, maximumEdges);
    std::vector<ChainFit> chains;
    std::size_t best = 0;
    for (std::size_t edges = closed ? 3 : 1; edges <= runs.maximumEdges(); ++edges) {
        chains.push_back(fitChain(points, columns, runs.vertices(edges), closed, edges <= roughEdges));
        if (chains.back().evidence.logEvidence > chains[best].evidence.logEvidence)
            best = chains.size() - 1;
        else if (chains.size() - 1 - best >= kPatience)
            break;
    }
    return chains;
}

ChainFit fitClosedChain(std::span<const Point> points, const Eigen::VectorXd& start) {
    return fitChain(points, PointColumns(points), start, true, true);
}

RobustFit refinedClosedChain(std::span<const Point> points, const ChainFit& chain) {
    const PointColumns columns(points);
    return refined(PolylineModel(columns, true, kFarthestVertex), chain.fit);
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
    std::vector<ChainFit> chains = fitChains(ordered, ordered, isClosed, kMaximumEdges);
    if (chains.empty())
        chains = fitChains(ordered, ordered, false, kMaximumEdges);
    const auto best = std::ranges::max_element(
        chains, {}, [](const ChainFit& chain) { return chain.evidence.logEvidence; });
    polygon.closed = best->closed;
    polygon.rms_m = contour.size_m * rmsOfInliers(best->fit, best->evidence);
    polygon.outliers = contour.rejected + best->evidence.outlierCount();
    for (const Point& p : toVertices(best->fit.parameters))
        polygon.vertices_m.push_back(contour.toMetres(p));
    return polygon;
}

} // namespace teleta::contour
