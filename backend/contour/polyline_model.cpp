// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polyline_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::contour {

namespace {

constexpr double kShortestEdge = 1e-9;
constexpr double kParallelSine = 0.05;
constexpr double kFarthestRunVertex = 0.6; ///< from the ends of the runs that meet in it
constexpr std::size_t kPointsOfRun = 2;

struct Nearest {
    Eigen::Index edge = 0;
    double share = 0.0;    ///< of the edge, within its reach
    double distance = 0.0; ///< signed
    Point gradient = Point::Zero();
};

class Edges {
public:
    Edges(const Eigen::VectorXd& vertices, bool closed)
        : m_closed(closed) {
        const Eigen::Index count = vertices.size() / 2;
        for (Eigen::Index e = 0; e < (closed ? count : count - 1); ++e) {
            const Point start = vertices.segment<2>(2 * e);
            const Point along = Point(vertices.segment<2>(2 * ((e + 1) % count))) - start;
            const double length2 = along.squaredNorm();
            m_edges.push_back({start, along, length2 > kShortestEdge * kShortestEdge ? 1.0 / length2 : 0.0});
        }
    }

    [[nodiscard]] Nearest nearest(const Point& p) const {
        std::size_t edge = 0;
        double share = 0.0;
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t e = 0; e < m_edges.size(); ++e) {
            const Point from = p - m_edges[e].start;
            double s = from.dot(m_edges[e].along) * m_edges[e].inverse;
            if (m_closed || e > 0)
                s = std::max(s, 0.0);
            if (m_closed || e + 1 < m_edges.size())
                s = std::min(s, 1.0);
            const double away2 = (from - s * m_edges[e].along).squaredNorm();
            if (away2 < smallest) {
                smallest = away2;
                edge = e;
                share = s;
            }
        }
        const Edge& nearestEdge = m_edges[edge];
        const Point from = p - nearestEdge.start;
        const bool reachesBack = !m_closed && edge == 0;
        const bool reachesOn = !m_closed && edge + 1 == m_edges.size();
        Nearest result;
        result.edge = static_cast<Eigen::Index>(edge);
        result.share = share;
        if (nearestEdge.inverse > 0.0 && (share > 0.0 || reachesBack) && (share < 1.0 || reachesOn)) {
            result.gradient =
                Point(-nearestEdge.along.y(), nearestEdge.along.x()) * std::sqrt(nearestEdge.inverse);
            result.distance = result.gradient.dot(from);
        } else {
            const Point away = from - share * nearestEdge.along;
            const double distance = away.norm();
            const double side = cross(nearestEdge.along, from) < 0.0 ? -1.0 : 1.0;
            result.distance = side * distance;
            if (distance > 0.0)
                result.gradient = side / distance * away;
        }
        return result;
    }

private:
    struct Edge {
        Point start;
        Point along;
        double inverse; ///< of the squared length; 0 of an edge without length
    };
    std::vector<Edge> m_edges;
    bool m_closed;
};

} // namespace

void polylineResiduals(std::span<const Point> points, const Eigen::VectorXd& vertices, bool closed,
                       Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) {
    const auto rows = static_cast<Eigen::Index>(points.size());
    const Eigen::Index count = vertices.size() / 2;
    residuals.resize(rows);
    jacobian.setZero(rows, vertices.size());
    const Edges edges(vertices, closed);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const Nearest n = edges.nearest(points[static_cast<std::size_t>(i)]);
        residuals[i] = n.distance;
        jacobian.block<1, 2>(i, 2 * n.edge) = -(1.0 - n.share) * n.gradient.transpose();
        jacobian.block<1, 2>(i, 2 * ((n.edge + 1) % count)) = -n.share * n.gradient.transpose();
    }
}

std::vector<double> placesOnPolyline(std::span<const Point> points, const Eigen::VectorXd& vertices,
                                     bool closed) {
    std::vector<double> places;
    places.reserve(points.size());
    const Edges edges(vertices, closed);
    for (const Point& p : points) {
        const Nearest n = edges.nearest(p);
        places.push_back(static_cast<double>(n.edge) + n.share);
    }
    return places;
}

std::vector<double> waysOnPolyline(std::span<const Point> points, const Eigen::VectorXd& vertices,
                                   bool closed) {
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
    if (closed)
        m_points.insert(m_points.end(), points.begin(), points.end());
    m_sums.resize(m_points.size() + 1, Eigen::Matrix<double, 5, 1>::Zero());
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const Point& p = m_points[i];
        Eigen::Matrix<double, 5, 1> terms;
        terms << p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
        m_sums[i + 1] = m_sums[i] + terms;
    }
    m_division = divide(0);
}

double EdgeRuns::cost(std::size_t begin, std::size_t end) const {
    const auto n = static_cast<double>(end - begin);
    const Eigen::Matrix<double, 5, 1> s = m_sums[end] - m_sums[begin];
    const double xx = s[2] - s[0] * s[0] / n;
    const double xy = s[3] - s[0] * s[1] / n;
    const double yy = s[4] - s[1] * s[1] / n;
    return std::max(0.0, 0.5 * (xx + yy - std::sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy)));
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

EdgeRuns::Division EdgeRuns::divide(std::size_t first) const {
    const std::size_t columns = m_count + 1;
    Division division;
    division.cost.assign((m_maximumEdges + 1) * columns, std::numeric_limits<double>::infinity());
    division.previous.assign(division.cost.size(), 0);
    division.cost[0] = 0.0;
    for (std::size_t end = kPointsOfRun; end <= m_count; ++end)
        for (std::size_t begin = 0; begin + kPointsOfRun <= end; ++begin) {
            const double run = cost(first + begin, first + end);
            for (std::size_t runs = 1; runs <= m_maximumEdges; ++runs) {
                const double total = division.cost[(runs - 1) * columns + begin] + run;
                double& least = division.cost[runs * columns + end];
                if (total < least) {
                    least = total;
                    division.previous[runs * columns + end] = begin;
                }
            }
        }
    return division;
}

std::vector<std::size_t> EdgeRuns::starts(const Division& division, std::size_t edges) const {
    std::vector<std::size_t> result(edges);
    std::size_t end = m_count;
    for (std::size_t run = edges; run > 0; --run) {
        end = division.previous[run * (m_count + 1) + end];
        result[run - 1] = end;
    }
    return result;
}

Eigen::VectorXd EdgeRuns::vertices(std::size_t edges) const {
    std::size_t first = 0;
    std::vector<std::size_t> begins = starts(m_division, edges);
    if (m_closed) {
        // The first division has a vertex at the arbitrary first point; a second one that starts at another
        // vertex removes it.
        first = begins[edges / 2];
        begins = starts(divide(first), edges);
    }
    std::vector<Line> lines;
    for (std::size_t run = 0; run < edges; ++run)
        lines.push_back(line(first + begins[run], first + (run + 1 < edges ? begins[run + 1] : m_count)));

    const auto meeting = [&](std::size_t before, std::size_t after) {
        const std::size_t place = first + begins[after];
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
