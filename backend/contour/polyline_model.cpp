// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polyline_model.h"

#include "backend/contour/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace teleta::contour {

namespace {

constexpr double kShortestEdge = 1e-9;
constexpr double kParallelSine = 0.05;
constexpr double kFarthestRunVertex = 0.6; ///< from the ends of the runs that meet in it
constexpr std::size_t kPointsOfRun = 2;

struct Edge {
    double x; ///< of its start
    double y;
    double alongX;
    double alongY;
    double normalX; ///< to the left; of an edge without length 0
    double normalY;
    double inverse; ///< of the squared length; 0 of an edge without length
    double least;   ///< share of its length within its reach
    double most;
};

/// Edges of a chain of at most kMostParameters coordinates are kept on the stack.
class Edges {
public:
    Edges(std::span<const double> vertices, bool closed);
    [[nodiscard]] std::span<const Edge> all() const { return {m_edges.data(), m_count}; }

private:
    std::size_t m_count;
    std::array<Edge, kMostParameters / 2> m_edges;
};

Edges::Edges(std::span<const double> vertices, bool closed)
    : m_count(vertices.size() / 2 - (closed ? 0 : 1)) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const std::size_t count = vertices.size() / 2;
    for (std::size_t e = 0; e < m_count; ++e) {
        const std::size_t next = e + 1 < count ? e + 1 : 0;
        Edge& edge = m_edges[e];
        edge.x = vertices[2 * e];
        edge.y = vertices[2 * e + 1];
        edge.alongX = vertices[2 * next] - edge.x;
        edge.alongY = vertices[2 * next + 1] - edge.y;
        const double length2 = edge.alongX * edge.alongX + edge.alongY * edge.alongY;
        edge.inverse = length2 > kShortestEdge * kShortestEdge ? 1.0 / length2 : 0.0;
        const double inverse = std::sqrt(edge.inverse);
        edge.normalX = -edge.alongY * inverse;
        edge.normalY = edge.alongX * inverse;
        edge.least = closed || e > 0 ? 0.0 : -kFar;
        edge.most = closed || e + 1 < m_count ? 1.0 : kFar;
    }
}

/// Index of the nearest edge of each point and the place on it, as share of its length.
void findNearest(const PointColumns& points, std::span<const Edge> edges, double* nearest, double* shares) {
    doInLanes([&]() __attribute__((always_inline)) {
        for (std::size_t i = 0; i < points.filled(); i += kLanes) {
            Lanes x, y;
            load(x, points.x.data() + i);
            load(y, points.y.data() + i);
            Lanes edge{}, share{}, index{};
            Lanes smallest = std::numeric_limits<double>::infinity() - Lanes{};
            for (const Edge& e : edges) {
                const Lanes fromX = x - e.x;
                const Lanes fromY = y - e.y;
                Lanes s = (fromX * e.alongX + fromY * e.alongY) * e.inverse;
                s = s < e.least ? e.least - Lanes{} : s;
                s = s > e.most ? e.most - Lanes{} : s;
                const Lanes awayX = fromX - s * e.alongX;
                const Lanes awayY = fromY - s * e.alongY;
                const Lanes away2 = awayX * awayX + awayY * awayY;
                const auto nearer = away2 < smallest;
                smallest = nearer ? away2 : smallest;
                edge = nearer ? index : edge;
                share = nearer ? s : share;
                index += 1.0;
            }
            store(nearest + i, edge);
            store(shares + i, share);
        }
    });
}

std::span<const double> numbersOf(const auto& vertices) {
    return {vertices.data(), static_cast<std::size_t>(vertices.size())};
}

/// Whether there are an edge and a place for each.
bool isChain(const Eigen::VectorXd& vertices) {
    return vertices.size() >= 4 && vertices.size() <= kMostParameters && vertices.size() % 2 == 0;
}

} // namespace

// The derivatives are four columns: the nearest edge, the share of its length, and the derivative of the
// distance by the point.
void PolylineModel::evaluate(At& at) const {
    const std::size_t filled = m_points.filled();
    at.residuals.resize(filled);
    at.derivatives.resize(4 * filled);
    double* nearest = at.derivatives.data();
    double* shares = nearest + filled;
    double* byX = shares + filled;
    double* byY = byX + filled;
    const Edges chain(numbersOf(at.parameters), m_closed);
    const std::span<const Edge> edges = chain.all();
    findNearest(m_points, edges, nearest, shares);
    for (std::size_t i = 0; i < filled; ++i) {
        const Edge& edge = edges[static_cast<std::size_t>(nearest[i])];
        const double share = shares[i];
        const double fromX = m_points.x[i] - edge.x;
        const double fromY = m_points.y[i] - edge.y;
        if (edge.inverse > 0.0 && share > edge.least && share < edge.most) {
            byX[i] = edge.normalX;
            byY[i] = edge.normalY;
            at.residuals[i] = byX[i] * fromX + byY[i] * fromY;
        } else {
            const double awayX = fromX - share * edge.alongX;
            const double awayY = fromY - share * edge.alongY;
            const double distance = std::sqrt(awayX * awayX + awayY * awayY);
            const double side = edge.alongX * fromY - edge.alongY * fromX < 0.0 ? -1.0 : 1.0;
            const double scale = distance > 0.0 ? side / distance : 0.0;
            byX[i] = scale * awayX;
            byY[i] = scale * awayY;
            at.residuals[i] = side * distance;
        }
    }
    if (at.parameters.cwiseAbs().maxCoeff() > m_farthest)
        std::ranges::fill(at.residuals, m_farthest);
}

void PolylineModel::equations(const At& at, const double* weights, const double* weightedResiduals,
                              StepEquations& equations) const {
    const std::size_t filled = m_points.filled();
    const double* nearest = at.derivatives.data();
    const double* shares = nearest + filled;
    const double* byX = shares + filled;
    const double* byY = byX + filled;
    const auto vertices = static_cast<std::size_t>(at.parameters.size()) / 2;
    // Sums of each edge: the squares and products by its start, by its start and end, by its end; then the
    // gradient by its start and by its end.
    std::array<std::array<double, 4 * kLanes>, kMostParameters / 2> sums;
    const std::size_t edges = m_closed ? vertices : vertices - 1;
    std::fill(sums.begin(), sums.begin() + edges, std::array<double, 4 * kLanes>{});
    doInLanes([&]() __attribute__((always_inline)) {
        for (std::size_t i = 0; i < m_points.count; ++i) {
            double* edge = sums[static_cast<std::size_t>(nearest[i])].data();
            const double atEnd = shares[i];
            const double atStart = 1.0 - atEnd;
            const double weightedX = weights[i] * byX[i];
            const Lanes squares{weightedX * byX[i], weightedX * byY[i], weights[i] * byY[i] * byY[i], 0.0};
            const double gradientX = weightedResiduals[i] * byX[i];
            const double gradientY = weightedResiduals[i] * byY[i];
            const Lanes gradient{atStart * gradientX, atStart * gradientY, atEnd * gradientX,
                                 atEnd * gradientY};
            Lanes first, mixed, last, slopes;
            load(first, edge);
            load(mixed, edge + kLanes);
            load(last, edge + 2 * kLanes);
            load(slopes, edge + 3 * kLanes);
            store(edge, first + atStart * atStart * squares);
            store(edge + kLanes, mixed + atStart * atEnd * squares);
            store(edge + 2 * kLanes, last + atEnd * atEnd * squares);
            store(edge + 3 * kLanes, slopes - gradient);
        }
    });
    equations.count = static_cast<int>(2 * vertices);
    for (int column = 0; column < equations.count; ++column) {
        const int own = column - column % 2;
        const bool closing = m_closed && own + 2 == equations.count;
        const int first = closing ? 0 : std::max(0, own - 2);
        equations.first[static_cast<std::size_t>(column)] = first;
        for (int row = first; row <= column; ++row)
            equations.at(row, column) = 0.0;
        equations.gradient[static_cast<std::size_t>(column)] = 0.0;
    }
    for (std::size_t e = 0; e < edges; ++e) {
        const double* first = sums[e].data();
        const double* mixed = first + kLanes;
        const double* last = mixed + kLanes;
        const double* slopes = last + kLanes;
        const auto start = static_cast<int>(2 * e);
        const int end = e + 1 < vertices ? start + 2 : 0;
        equations.at(start, start) += first[0];
        equations.at(start, start + 1) += first[1];
        equations.at(start + 1, start + 1) += first[2];
        equations.at(end, end) += last[0];
        equations.at(end, end + 1) += last[1];
        equations.at(end + 1, end + 1) += last[2];
        const int before = std::min(start, end);
        const int after = std::max(start, end);
        equations.at(before, after) += mixed[0];
        equations.at(before + 1, after) += mixed[1];
        equations.at(before, after + 1) += mixed[1];
        equations.at(before + 1, after + 1) += mixed[2];
        equations.gradient[static_cast<std::size_t>(start)] += slopes[0];
        equations.gradient[static_cast<std::size_t>(start) + 1] += slopes[1];
        equations.gradient[static_cast<std::size_t>(end)] += slopes[2];
        equations.gradient[static_cast<std::size_t>(end) + 1] += slopes[3];
    }
}

Eigen::MatrixXd PolylineModel::jacobian(const At& at) const {
    const std::size_t filled = m_points.filled();
    const Eigen::Index parameters = at.parameters.size();
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m_points.count), parameters);
    for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
        const double* numbers = at.derivatives.data() + i;
        const auto start = 2 * static_cast<Eigen::Index>(numbers[0]);
        const Eigen::Index end = (start + 2) % parameters;
        const double share = numbers[filled];
        const double byX = numbers[2 * filled];
        const double byY = numbers[3 * filled];
        jacobian(i, start) = -(1.0 - share) * byX;
        jacobian(i, start + 1) = -(1.0 - share) * byY;
        jacobian(i, end) = -share * byX;
        jacobian(i, end + 1) = -share * byY;
    }
    return jacobian;
}

RobustFit PolylineModel::fitAt(const Eigen::VectorXd& vertices) const {
    At at;
    at.parameters = vertices;
    evaluate(at);
    return {vertices,
            Eigen::Map<const Eigen::VectorXd>(at.residuals.data(), static_cast<Eigen::Index>(m_points.count)),
            jacobian(at)};
}

std::vector<double> placesOnPolyline(std::span<const Point> points, const Eigen::VectorXd& vertices,
                                     bool closed) {
    if (!isChain(vertices))
        return std::vector<double>(points.size(), std::numeric_limits<double>::quiet_NaN());
    const PointColumns columns(points);
    std::vector<double> places(columns.filled());
    std::vector<double> shares(columns.filled());
    findNearest(columns, Edges(numbersOf(vertices), closed).all(), places.data(), shares.data());
    places.resize(points.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] += shares[i];
    return places;
}

std::vector<double> waysOnPolyline(std::span<const Point> points, const Eigen::VectorXd& vertices,
                                   bool closed) {
    if (!isChain(vertices))
        return std::vector<double>(points.size(), std::numeric_limits<double>::quiet_NaN());
    const std::vector<Point> corners = toVertices(vertices);
    const std::size_t edges = closed ? corners.size() : corners.size() - 1;
    std::vector<double> begins{0.0};
    for (std::size_t i = 0; i < edges; ++i)
        begins.push_back(begins.back() + (corners[(i + 1) % corners.size()] - corners[i]).norm());
    std::vector<double> ways = placesOnPolyline(points, vertices, closed);
    for (double& way : ways) {
        const double edge = std::clamp(std::floor(way), 0.0, static_cast<double>(edges - 1));
        const auto begin = static_cast<std::size_t>(edge);
        way = begins[begin] + (way - edge) * (begins[begin + 1] - begins[begin]);
    }
    return ways;
}

double polylineLength(const Eigen::VectorXd& vertices, bool closed) {
    const Eigen::Index count = vertices.size() / 2;
    double length = 0.0;
    for (Eigen::Index e = 0; e < (closed ? count : count - 1); ++e)
        length += (vertices.segment<2>(2 * ((e + 1) % count)) - vertices.segment<2>(2 * e)).norm();
    return length;
}

std::vector<Point> toVertices(const Eigen::VectorXd& coordinates) {
    std::vector<Point> vertices;
    for (Eigen::Index i = 0; i + 1 < coordinates.size(); i += 2)
        vertices.emplace_back(coordinates.segment<2>(i));
    return vertices;
}

EdgeRuns::EdgeRuns(std::span<const Point> points, bool closed, std::size_t maximumEdges)
    : m_count(points.size())
    , m_closed(closed)
    , m_maximumEdges(std::min(maximumEdges, points.size() / kPointsOfRun))
    , m_points(points.begin(), points.end()) {
    // A closed contour begins where it is farthest from its middle, which of a polygon is at a vertex.
    if (closed && m_count > 0) {
        const Point middle = std::accumulate(points.begin(), points.end(), Point(Point::Zero())) /
                             static_cast<double>(m_count);
        const auto farthest = std::ranges::max_element(
            m_points, {}, [&](const Point& p) { return (p - middle).squaredNorm(); });
        std::rotate(m_points.begin(), farthest, m_points.end());
    }
    measureRuns();
    divide(std::min(m_maximumEdges + 1, m_count / kPointsOfRun));
}

/// Squared distances of the points from the total-least-squares line of each run.
void EdgeRuns::measureRuns() {
    m_stride = m_count + 1 + kLanes;
    std::array<std::vector<double>, 5> sums; // of x, y, x^2, xy, y^2 of the points before
    for (std::vector<double>& sum : sums)
        sum.assign(m_stride, 0.0);
    for (std::size_t i = 0; i < m_count; ++i) {
        const Point& p = m_points[i];
        const std::array<double, 5> terms{p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y()};
        for (std::size_t k = 0; k < terms.size(); ++k)
            sums[k][i + 1] = sums[k][i] + terms[k];
    }
    // Of each end the runs by where they begin.
    m_costs.resize((m_count + 1) * m_stride);
    doInLanes([&]() __attribute__((always_inline)) {
        for (std::size_t end = kPointsOfRun; end <= m_count; ++end) {
            double* costs = m_costs.data() + end * m_stride;
            Lanes n = static_cast<double>(end) - Lanes{0.0, 1.0, 2.0, 3.0};
            for (std::size_t begin = 0; begin + kPointsOfRun <= end; begin += kLanes) {
                std::array<Lanes, 5> of;
                for (std::size_t k = 0; k < of.size(); ++k) {
                    load(of[k], sums[k].data() + begin);
                    of[k] = sums[k][end] - of[k];
                }
                const Lanes inverse = 1.0 / (n > 1.0 ? n : 1.0 - Lanes{});
                const Lanes xx = of[2] - of[0] * of[0] * inverse;
                const Lanes xy = of[3] - of[0] * of[1] * inverse;
                const Lanes yy = of[4] - of[1] * of[1] * inverse;
                const Lanes root2 = (xx - yy) * (xx - yy) + 4.0 * xy * xy;
                Lanes cost = xx + yy;
                for (std::size_t lane = 0; lane < kLanes; ++lane)
                    cost[lane] -= __builtin_sqrt(root2[lane]);
                cost *= 0.5;
                store(costs + begin, cost > 0.0 ? cost : Lanes{});
                n -= static_cast<double>(kLanes);
            }
        }
    });
}

double EdgeRuns::leastSquares(std::size_t edges) const {
    return m_division.cost[m_count * m_division.width + std::min(edges + 1, m_count / kPointsOfRun)];
}

EdgeRuns::Line EdgeRuns::line(std::size_t begin, std::size_t end) const {
    const auto n = static_cast<double>(end - begin);
    Point middle = Point::Zero();
    for (std::size_t i = begin; i < end; ++i)
        middle += m_points[i] / n;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const Point d = m_points[i] - middle;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {middle, {std::cos(angle), std::sin(angle)}};
}

void EdgeRuns::divide(std::size_t edges) {
    m_division.width = edges + 1 + kLanes; // several numbers of runs at once may reach beyond the last
    m_division.cost.assign((m_count + 1) * m_division.width, std::numeric_limits<double>::infinity());
    m_division.previous.assign(m_division.cost.size(), 0.0);
    m_division.cost[0] = 0.0;
    doInLanes([&]() __attribute__((always_inline)) {
        for (std::size_t end = kPointsOfRun; end <= m_count; ++end)
            for (std::size_t runs = 1; runs <= edges; runs += kLanes) {
                const double* costs = m_costs.data() + end * m_stride;
                const double* before = m_division.cost.data() + runs - 1;
                Lanes least = std::numeric_limits<double>::infinity() - Lanes{};
                Lanes from{};
                Lanes begin{};
                for (std::size_t i = 0; i + kPointsOfRun <= end; ++i) {
                    Lanes total;
                    load(total, before + i * m_division.width);
                    total += costs[i];
                    const auto less = total < least;
                    least = less ? total : least;
                    from = less ? begin : from;
                    begin += 1.0;
                }
                store(m_division.cost.data() + end * m_division.width + runs, least);
                store(m_division.previous.data() + end * m_division.width + runs, from);
            }
    });
}

std::vector<std::size_t> EdgeRuns::starts(std::size_t edges) const {
    std::vector<std::size_t> result(edges);
    std::size_t end = m_count;
    for (std::size_t run = edges; run > 0; --run) {
        end = static_cast<std::size_t>(m_division.previous[end * m_division.width + run]);
        result[run - 1] = end;
    }
    return result;
}

Eigen::VectorXd EdgeRuns::vertices(std::size_t edges) const {
    const std::vector<std::size_t> begins = starts(edges);
    std::vector<Line> lines;
    for (std::size_t run = 0; run < edges; ++run)
        lines.push_back(line(begins[run], run + 1 < edges ? begins[run + 1] : m_count));

    const auto meeting = [&](std::size_t before, std::size_t after) {
        const std::size_t place = begins[after];
        const Point between = 0.5 * (m_points[place] + m_points[place > 0 ? place - 1 : m_count - 1]);
        const Line& a = lines[before];
        const Line& b = lines[after];
        const double sine = cross(a.direction, b.direction);
        if (std::abs(sine) < kParallelSine)
            return between;
        const Point vertex = a.middle + cross(b.middle - a.middle, b.direction) / sine * a.direction;
        return (vertex - between).norm() > kFarthestRunVertex ? between : vertex;
    };

    std::vector<Point> chain;
    if (m_closed) {
        for (std::size_t run = 0; run < edges; ++run)
            chain.push_back(meeting((run + edges - 1) % edges, run));
    } else {
        const auto foot = [](const Line& l, const Point& p) -> Point {
            return l.middle + (p - l.middle).dot(l.direction) * l.direction;
        };
        chain.push_back(foot(lines.front(), m_points.front()));
        for (std::size_t run = 1; run < edges; ++run)
            chain.push_back(meeting(run - 1, run));
        chain.push_back(foot(lines.back(), m_points.back()));
    }
    Eigen::VectorXd coordinates(2 * static_cast<Eigen::Index>(chain.size()));
    for (std::size_t i = 0; i < chain.size(); ++i)
        coordinates.segment<2>(2 * static_cast<Eigen::Index>(i)) = chain[i];
    return coordinates;
}

} // namespace teleta::contour
