// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polygon_models.h"

#include "backend/contour/polyline_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::contour {

namespace {

constexpr double kTouchedMargin =
    0.05; ///< of an edge; nearer to a vertex the point may belong to the next edge
constexpr std::size_t kPolygonStartsRefined = 4;

/// (centre x, centre y, angle, half width, half height) to the coordinates of four vertices.
Eigen::VectorXd corners(const Eigen::VectorXd& box) {
    const double c = std::cos(box[2]);
    const double s = std::sin(box[2]);
    Eigen::VectorXd vertices(8);
    for (Eigen::Index i = 0; i < 4; ++i) {
        const double u = (i == 0 || i == 3 ? -1.0 : 1.0) * box[3];
        const double v = (i < 2 ? -1.0 : 1.0) * box[4];
        vertices[2 * i] = box[0] + c * u - s * v;
        vertices[2 * i + 1] = box[1] + s * u + c * v;
    }
    return vertices;
}

Eigen::Matrix<double, 8, 5> cornerDerivatives(const Eigen::VectorXd& box) {
    const double c = std::cos(box[2]);
    const double s = std::sin(box[2]);
    Eigen::Matrix<double, 8, 5> derivatives;
    for (Eigen::Index i = 0; i < 4; ++i) {
        const double su = i == 0 || i == 3 ? -1.0 : 1.0;
        const double sv = i < 2 ? -1.0 : 1.0;
        const double u = su * box[3];
        const double v = sv * box[4];
        derivatives.row(2 * i) << 1.0, 0.0, -s * u - c * v, c * su, -s * sv;
        derivatives.row(2 * i + 1) << 0.0, 1.0, c * u - s * v, s * su, c * sv;
    }
    return derivatives;
}

/// Boxes at several angles around the middle nine tenths of the points.
std::vector<Eigen::VectorXd> boxesAround(std::span<const Point> points) {
    constexpr int kAngles = 6;
    std::vector<Eigen::VectorXd> starts;
    std::vector<double> u(points.size());
    std::vector<double> v(points.size());
    const std::size_t cut = points.size() / 20;
    for (int k = 0; k < kAngles; ++k) {
        const double angle = 0.5 * std::numbers::pi * k / kAngles;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (std::size_t i = 0; i < points.size(); ++i) {
            u[i] = c * points[i].x() + s * points[i].y();
            v[i] = c * points[i].y() - s * points[i].x();
        }
        std::sort(u.begin(), u.end());
        std::sort(v.begin(), v.end());
        const double u0 = u[cut], u1 = u[u.size() - 1 - cut];
        const double v0 = v[cut], v1 = v[v.size() - 1 - cut];
        Eigen::VectorXd box(5);
        box << 0.5 * (c * (u0 + u1) - s * (v0 + v1)), 0.5 * (s * (u0 + u1) + c * (v0 + v1)), angle,
            0.5 * (u1 - u0), 0.5 * (v1 - v0);
        starts.push_back(box);
    }
    return starts;
}

/// Box with the edge directions (mean of four-fold angles), centre and side lengths of a quadrilateral.
Eigen::VectorXd boxNear(const Eigen::VectorXd& quadrilateral) {
    const std::vector<Point> p = toVertices(quadrilateral);
    double sine = 0.0;
    double cosine = 0.0;
    Point centre = Point::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        const Point edge = p[(i + 1) % 4] - p[i];
        const double angle = std::atan2(edge.y(), edge.x());
        sine += edge.norm() * std::sin(4.0 * angle);
        cosine += edge.norm() * std::cos(4.0 * angle);
        centre += 0.25 * p[i];
    }
    const double angle = 0.25 * std::atan2(sine, cosine);
    const Point axis(std::cos(angle), std::sin(angle));
    double width = 0.0;
    double height = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point edge = p[(i + 1) % 4] - p[i];
        width += 0.25 * std::abs(edge.dot(axis));
        height += 0.25 * std::abs(cross(edge, axis));
    }
    Eigen::VectorXd box(5);
    box << centre.x(), centre.y(), angle, width, height;
    return box;
}

void keepBetter(PolygonFit& best, RobustFit fit, const auto& verticesOf) {
    Evidence judged = evidence(fit, polylineLength(verticesOf(fit.parameters), true));
    if (judged.logEvidence > best.judged.logEvidence)
        best = {std::move(fit), std::move(judged), {}};
}

} // namespace

PolygonFit fitRectangle(std::span<const Point> points, const std::vector<Eigen::VectorXd>& quadrilaterals) {
    Eigen::MatrixXd byVertices;
    const Residuals evaluate = [&](const Eigen::VectorXd& box, Eigen::VectorXd& r, Eigen::MatrixXd& j) {
        polylineResiduals(points, corners(box), true, r, byVertices);
        j.noalias() = byVertices.lazyProduct(cornerDerivatives(box));
    };
    std::vector<Eigen::VectorXd> starts = boxesAround(points);
    for (const Eigen::VectorXd& quadrilateral : quadrilaterals)
        starts.push_back(boxNear(quadrilateral));
    std::vector<std::pair<double, std::size_t>> order;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        evaluate(starts[i], residuals, jacobian);
        order.emplace_back(robustLoss(residuals, kStartScale), i);
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), kPolygonStartsRefined));

    PolygonFit best;
    for (const auto& [loss, start] : order)
        keepBetter(best, fitRobustly(evaluate, starts[start]), corners);
    best.fit.parameters.tail<2>() = best.fit.parameters.tail<2>().cwiseAbs().eval();
    best.vertices = corners(best.fit.parameters);
    return best;
}

PolygonFit fitRegularPolygon(std::span<const Point> points, int sides, const Point& centre, double radius) {
    constexpr int kAngles = 3;
    const double turn = 2.0 * std::numbers::pi / sides;
    const auto vertices = [&](const Eigen::VectorXd& p) {
        Eigen::VectorXd chain(2 * sides);
        const double radiusHere = std::exp(p[2]);
        for (int i = 0; i < sides; ++i) {
            chain[2 * i] = p[0] + radiusHere * std::cos(p[3] + i * turn);
            chain[2 * i + 1] = p[1] + radiusHere * std::sin(p[3] + i * turn);
        }
        return chain;
    };
    Eigen::MatrixXd byVertices;
    Eigen::MatrixXd derivatives(2 * sides, 4);
    const Residuals evaluate = [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd& j) {
        const Eigen::VectorXd chain = vertices(p);
        polylineResiduals(points, chain, true, r, byVertices);
        for (int i = 0; i < sides; ++i) {
            const double x = chain[2 * i] - p[0];
            const double y = chain[2 * i + 1] - p[1];
            derivatives.row(2 * i) << 1.0, 0.0, x, -y;
            derivatives.row(2 * i + 1) << 0.0, 1.0, y, x;
        }
        j.noalias() = byVertices.lazyProduct(derivatives);
    };
    PolygonFit best;
    for (int k = 0; k < kAngles; ++k) {
        const Eigen::Vector4d start(centre.x(), centre.y(), std::log(1.1 * radius), turn * k / kAngles);
        keepBetter(best, fitRobustly(evaluate, start), vertices);
    }
    best.vertices = vertices(best.fit.parameters);
    return best;
}

Eigen::VectorXd largeTriangle(std::span<const Point> points) {
    const std::size_t n = points.size();
    std::size_t a = 0, b = 0, c = 0;
    double widest = -1.0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (const double d = (points[i] - points[k]).squaredNorm(); d > widest) {
                widest = d;
                a = i;
                b = k;
            }
    const auto area = [&](std::size_t i, std::size_t k, std::size_t l) {
        return std::abs(cross(points[k] - points[i], points[l] - points[i]));
    };
    const auto improve = [&](std::size_t& moving, std::size_t p, std::size_t q) {
        for (std::size_t i = 0; i < n; ++i)
            if (area(i, p, q) > area(moving, p, q))
                moving = i;
    };
    for (int round = 0; round < 3; ++round) {
        improve(c, a, b);
        improve(a, b, c);
        improve(b, c, a);
    }
    Eigen::VectorXd vertices(6);
    vertices << points[a], points[b], points[c];
    return vertices;
}

double untouchedShare(std::vector<double> positions, double period) {
    if (positions.size() < 2 || period <= 0.0)
        return 0.0;
    std::sort(positions.begin(), positions.end());
    double widest = positions.front() + period - positions.back();
    double second = 0.0;
    for (std::size_t i = 1; i < positions.size(); ++i) {
        const double gap = positions[i] - positions[i - 1];
        second = std::max(second, std::min(gap, widest));
        widest = std::max(widest, gap);
    }
    return (widest - second) / period;
}

Explored explored(std::span<const Point> points, const Evidence& judged, const Eigen::VectorXd& vertices) {
    const std::vector<double> shares = placesOnPolyline(points, vertices, true);
    std::vector<bool> touched(static_cast<std::size_t>(vertices.size()) / 2, false);
    std::vector<double> positions;
    Explored result;
    result.period = polylineLength(vertices, true);
    result.places = waysOnPolyline(points, vertices, true);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (judged.outliers[i])
            continue;
        positions.push_back(result.places[i]);
        const auto edge = std::min(static_cast<std::size_t>(shares[i]), touched.size() - 1);
        const double share = shares[i] - static_cast<double>(edge);
        if (share > kTouchedMargin && share < 1.0 - kTouchedMargin)
            touched[edge] = true;
    }
    result.everyEdge = std::find(touched.begin(), touched.end(), false) == touched.end();
    result.untouched = untouchedShare(std::move(positions), result.period);
    result.length = result.period * (1.0 - result.untouched);
    return result;
}

} // namespace teleta::contour
