// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polygon_models.h"

#include "backend/contour/lanes.h"
#include "backend/contour/polyline_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::contour {

namespace {

constexpr double kTouchedMargin =
    0.05;                           ///< of an edge; nearer to a vertex the point may belong to the next edge
constexpr double kAtCorner = 1e-12; ///< nearer than this no direction leads away from a corner

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

/// Boxes at several angles around the middle nine tenths of the points.
std::vector<RobustModel::Parameters> boxesAround(std::span<const Point> points) {
    constexpr int kAngles = 6;
    std::vector<RobustModel::Parameters> starts;
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
        starts.emplace_back(box);
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

/// A rectangle; distances are positive inside. Symmetric in the signs of its halves.
class RectangleModel : public ColumnModel<5> {
public:
    using ColumnModel<5>::ColumnModel;
    void evaluate(At& at) const override {
        const auto columns = this->columns(at);
        double* const byX = columns[0];
        double* const byY = columns[1];
        double* const byAngle = columns[2];
        double* const byWidth = columns[3];
        double* const byHeight = columns[4];
        const PointColumns& p = points();
        const double c = std::cos(at.parameters[2]);
        const double s = std::sin(at.parameters[2]);
        const double width = std::abs(at.parameters[3]);
        const double height = std::abs(at.parameters[4]);
        const double widthSide = at.parameters[3] < 0.0 ? -1.0 : 1.0;
        const double heightSide = at.parameters[4] < 0.0 ? -1.0 : 1.0;
        doInLanes([&]() __attribute__((always_inline)) {
            for (std::size_t i = 0; i < p.filled(); i += kLanes) {
                Lanes x, y;
                load(x, p.x.data() + i, at.parameters[0]);
                load(y, p.y.data() + i, at.parameters[1]);
                const Lanes u = c * x + s * y;
                const Lanes v = c * y - s * x;
                const Lanes zero{};
                const Lanes one = 1.0 - zero;
                const Lanes uSide = u < zero ? -one : one;
                const Lanes vSide = v < zero ? -one : one;
                const Lanes beyondU = u * uSide - width;
                const Lanes beyondV = v * vSide - height;
                Lanes out = beyondU > beyondV ? beyondU : beyondV;
                Lanes slopeU = beyondU > beyondV ? one : zero;
                Lanes slopeV = one - slopeU;
                for (std::size_t lane = 0; lane < kLanes; ++lane)
                    if (beyondU[lane] > -kAtCorner && beyondV[lane] > -kAtCorner) { // nearest to a corner
                        const double away =
                            std::sqrt(beyondU[lane] * beyondU[lane] + beyondV[lane] * beyondV[lane]);
                        const double inverse = away > kAtCorner ? 1.0 / away : 0.0;
                        out[lane] = away;
                        slopeU[lane] = beyondU[lane] * inverse;
                        slopeV[lane] = beyondV[lane] * inverse;
                    }
                store(at.residuals.data() + i, -out);
                store(byWidth + i, slopeU * widthSide);
                store(byHeight + i, slopeV * heightSide);
                slopeU *= uSide;
                slopeV *= vSide;
                store(byX + i, c * slopeU - s * slopeV);
                store(byY + i, s * slopeU + c * slopeV);
                store(byAngle + i, slopeV * u - slopeU * v);
            }
        });
    }
};

/// A regular polygon, one of whose corners is at the angle; distances are positive inside.
class RegularPolygonModel : public ColumnModel<4> {
public:
    RegularPolygonModel(const PointColumns& points, int sides)
        : ColumnModel<4>(points)
        , m_sides(sides) {}
    void evaluate(At& at) const override {
        const auto columns = this->columns(at);
        double* const byX = columns[0];
        double* const byY = columns[1];
        double* const byLogRadius = columns[2];
        double* const byAngle = columns[3];
        const PointColumns& p = points();
        const double half_rad = std::numbers::pi / m_sides;
        const double radius = std::exp(at.parameters[2]);
        const double apothem = radius * std::cos(half_rad);
        const double half = radius * std::sin(half_rad);
        std::array<std::array<double, 2>, kMostSides> normals; // outward, of each edge
        for (int e = 0; e < m_sides; ++e) {
            const double angle_rad = at.parameters[3] + (2 * e + 1) * half_rad;
            normals[static_cast<std::size_t>(e)] = {std::cos(angle_rad), std::sin(angle_rad)};
        }
        doInLanes([&]() __attribute__((always_inline)) {
            for (std::size_t i = 0; i < p.filled(); i += kLanes) {
                Lanes x, y;
                load(x, p.x.data() + i, at.parameters[0]);
                load(y, p.y.data() + i, at.parameters[1]);
                Lanes c = normals[0][0] - Lanes{};
                Lanes s = normals[0][1] - Lanes{};
                Lanes across = c * x + s * y;
                for (int e = 1; e < m_sides; ++e) {
                    const auto& [cosine, sine] = normals[static_cast<std::size_t>(e)];
                    const Lanes here = cosine * x + sine * y;
                    const auto nearer = here > across;
                    across = nearer ? here : across;
                    c = nearer ? cosine - Lanes{} : c;
                    s = nearer ? sine - Lanes{} : s;
                }
                const Lanes along = c * y - s * x;
                Lanes out = across - apothem;
                Lanes slope = 1.0 - Lanes{};
                Lanes slopeAlong{};
                for (std::size_t lane = 0; lane < kLanes; ++lane)
                    if (const double beyond = std::abs(along[lane]) - half;
                        beyond > -kAtCorner && out[lane] > -kAtCorner) {
                        const double away = std::sqrt(out[lane] * out[lane] + beyond * beyond);
                        const double inverse = away > kAtCorner ? 1.0 / away : 0.0;
                        slope[lane] = out[lane] * inverse;
                        slopeAlong[lane] = std::copysign(beyond * inverse, along[lane]);
                        out[lane] = away;
                    }
                store(at.residuals.data() + i, -out);
                store(byX + i, c * slope - s * slopeAlong);
                store(byY + i, s * slope + c * slopeAlong);
                const Lanes zero{};
                store(byLogRadius + i,
                      slope * apothem + (slopeAlong < zero ? -slopeAlong : slopeAlong) * half);
                store(byAngle + i, slopeAlong * across - slope * along);
            }
        });
    }

private:
    static constexpr std::size_t kMostSides = 6;
    int m_sides;
};

} // namespace

PolygonFit fitRectangle(std::span<const Point> points, const std::vector<Eigen::VectorXd>& quadrilaterals) {
    const PointColumns columns(points);
    const RectangleModel model(columns);
    std::vector<RobustModel::Parameters> starts = boxesAround(points);
    for (const Eigen::VectorXd& quadrilateral : quadrilaterals)
        starts.emplace_back(boxNear(quadrilateral));
    const auto length = [](const Eigen::VectorXd& box) {
        return 4.0 * (std::abs(box[3]) + std::abs(box[4]));
    };
    PolygonFit best{.fit = fitBest(model, starts, length), .vertices = {}};
    best.fit.parameters.tail<2>() = best.fit.parameters.tail<2>().cwiseAbs().eval();
    best.vertices = corners(best.fit.parameters);
    return best;
}

PolygonFit fitRegularPolygon(std::span<const Point> points, int sides, const Point& centre, double radius) {
    constexpr int kAngles = 4;
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
    const PointColumns columns(points);
    const RegularPolygonModel model(columns, sides);
    Eigen::Vector4d bestStart;
    double bestLoss = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kAngles; ++k) {
        const Eigen::Vector4d start(centre.x(), centre.y(), std::log(1.1 * radius), turn * k / kAngles);
        if (const double loss = lossOfStart(model, start); k == 0 || loss < bestLoss) {
            bestLoss = loss;
            bestStart = start;
        }
    }
    PolygonFit best{.fit = fitRobustly(model, bestStart), .vertices = {}};
    best.judged = evidence(best.fit, polylineLength(vertices(best.fit.parameters), true));
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
