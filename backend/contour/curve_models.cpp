// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/curve_models.h"

#include "backend/contour/lanes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace teleta::contour {

namespace {

constexpr double kSmallestE2 = 1e-6;
constexpr std::size_t kCurveStartsRefined = 1;

Point meanOf(std::span<const Point> points) {
    return std::accumulate(points.begin(), points.end(), Point(Point::Zero())) /
           static_cast<double>(points.size());
}

using Column = Eigen::Map<Eigen::ArrayXd>;

Column columnOf(double* numbers, const PointColumns& points) {
    return {numbers, static_cast<Eigen::Index>(points.filled())};
}

Eigen::Map<const Eigen::ArrayXd> columnOf(const std::vector<double>& numbers) {
    return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

/// parameters (A, D, theta).
class CurvedModel : public ColumnModel<3> {
public:
    CurvedModel(const PointColumns& points, const Point& reference)
        : ColumnModel<3>(points)
        , m_reference(reference) {}
    void evaluate(At& at) const override {
        const auto columns = this->columns(at);
        Column byA = columnOf(columns[0], points());
        Column byD = columnOf(columns[1], points());
        Column byTheta = columnOf(columns[2], points());
        Column distance = columnOf(at.residuals.data(), points());
        const double a = at.parameters[0];
        const double d = at.parameters[1];
        const double e = std::sqrt(std::max(kSmallestE2, 1.0 + 4.0 * a * d));
        const double c = std::cos(at.parameters[2]);
        const double s = std::sin(at.parameters[2]);
        const auto x = columnOf(points().x) - m_reference.x();
        const auto y = columnOf(points().y) - m_reference.y();
        // The columns first hold z, u and the power.
        byA = x * x + y * y;
        byD = c * x + s * y;
        distance = a * byA + e * byD + d;
        byTheta = (1.0 + 4.0 * a * distance).max(0.0).sqrt();
        distance = 2.0 * distance / (1.0 + byTheta);
        // d = P - A d^2 on the circle's side of its centre, hence dd = (dP - d^2 dA) / q.
        byTheta = 1.0 / byTheta.max(1e-3);
        byA = (byA + 2.0 * d / e * byD - distance * distance) * byTheta;
        byD = (1.0 + 2.0 * a / e * byD) * byTheta;
        byTheta = e * (c * y - s * x) * byTheta;
    }

private:
    Point m_reference;
};

/// parameters (D, theta).
class StraightModel : public ColumnModel<2> {
public:
    StraightModel(const PointColumns& points, const Point& reference)
        : ColumnModel<2>(points)
        , m_reference(reference) {}
    void evaluate(At& at) const override {
        const auto columns = this->columns(at);
        const double c = std::cos(at.parameters[1]);
        const double s = std::sin(at.parameters[1]);
        const auto x = columnOf(points().x) - m_reference.x();
        const auto y = columnOf(points().y) - m_reference.y();
        columnOf(at.residuals.data(), points()) = c * x + s * y + at.parameters[0];
        columnOf(columns[0], points()) = 1.0;
        columnOf(columns[1], points()) = c * y - s * x;
    }

private:
    Point m_reference;
};

std::optional<Eigen::Vector3d> circleThrough(const Point& p, const Point& q, const Point& r) {
    const Point a = q - p;
    const Point b = r - p;
    const double twice = 2.0 * cross(a, b);
    if (std::abs(twice) < 1e-6)
        return std::nullopt;
    const Point centre = Point(b.y() * a.squaredNorm() - a.y() * b.squaredNorm(),
                               a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) /
                         twice;
    return Eigen::Vector3d(p.x() + centre.x(), p.y() + centre.y(), centre.norm());
}

CurvedLine fromCircle(std::span<const Point> points, const Eigen::Vector3d& circle) {
    const Point centre = circle.head<2>();
    const double radius = circle[2];
    CurvedLine curve;
    curve.reference = *std::min_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
        return std::abs((p - centre).norm() - radius) < std::abs((q - centre).norm() - radius);
    });
    const Point o = centre - curve.reference;
    curve.a = 0.5 / radius;
    curve.d = (o.norm() - radius) * (o.norm() + radius) * curve.a;
    curve.theta_rad = std::atan2(-o.y(), -o.x());
    return curve;
}

/// (D, theta) of the total-least-squares line, from its points' mean.
Eigen::Vector2d leastSquaresLine(std::span<const Point> points, const Point& mean) {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const Point& p : points) {
        const Point d = p - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
    }
    return {0.0, 0.5 * std::atan2(2.0 * xy, xx - yy) + 0.5 * std::numbers::pi};
}

/// parameters: centre x, centre y, log a, log b, angle.
class EllipseModel : public ColumnModel<5> {
public:
    using ColumnModel<5>::ColumnModel;
    void evaluate(At& at) const override {
        const auto columns = this->columns(at);
        const double perA = std::exp(-at.parameters[2]);
        const double perB = std::exp(-at.parameters[3]);
        const double c = std::cos(at.parameters[4]);
        const double s = std::sin(at.parameters[4]);
        const PointColumns& p = points();
        doInLanes([&]() __attribute__((always_inline)) {
            for (std::size_t i = 0; i < p.filled(); i += kLanes) {
                Lanes x, y;
                load(x, p.x.data() + i, at.parameters[0]);
                load(y, p.y.data() + i, at.parameters[1]);
                // Along the axes, in their lengths.
                const Lanes u = (c * x + s * y) * perA;
                const Lanes v = (c * y - s * x) * perB;
                const Lanes ua = u * perA;
                const Lanes vb = v * perB;
                Lanes level = u * u + v * v;
                Lanes slope = ua * ua + vb * vb;
                // In the middle no direction is the nearest one.
                const auto middle = !(slope > 1e-18);
                slope = middle ? 1.0 - Lanes{} : slope;
                level = middle ? 1.0 - Lanes{} : level;
                takeRoots(level);
                takeRoots(slope);
                const Lanes perSlope = 1.0 / slope;
                const Lanes distance = level * (level - 1.0) * perSlope;
                const Lanes share = distance * perSlope * perSlope;
                const Lanes byLevel = (2.0 - 1.0 / level) * perSlope;
                const Lanes byU = byLevel * u - share * perA * ua;
                const Lanes byV = byLevel * v - share * perB * vb;
                // The slope also contains the length itself.
                Lanes byLogA = share * ua * ua - byU * u;
                Lanes byLogB = share * vb * vb - byV * v;
                const double inside = -std::min(1.0 / perA, 1.0 / perB);
                byLogA = middle ? (perA > perB ? inside : 0.0) - Lanes{} : byLogA;
                byLogB = middle ? (perA > perB ? 0.0 : inside) - Lanes{} : byLogB;
                const Lanes zero{};
                const Lanes byX = -byU * c * perA + byV * s * perB;
                const Lanes byY = -byU * s * perA - byV * c * perB;
                const Lanes byAngle = byU * v * perA / perB - byV * u * perB / perA;
                store(at.residuals.data() + i, middle ? inside - zero : distance);
                store(columns[0] + i, middle ? zero : byX);
                store(columns[1] + i, middle ? zero : byY);
                store(columns[2] + i, byLogA);
                store(columns[3] + i, byLogB);
                store(columns[4] + i, middle ? zero : byAngle);
            }
        });
    }
};

} // namespace

Point CurvedLine::centre() const {
    const double e = std::sqrt(std::max(kSmallestE2, 1.0 + 4.0 * a * d));
    return reference - Point(e * std::cos(theta_rad), e * std::sin(theta_rad)) / (2.0 * a);
}

Point CurvedLine::foot(const Point& p) const {
    const Point normal(std::cos(theta_rad), std::sin(theta_rad));
    return p - ((p - reference).dot(normal) + d) * normal;
}

std::optional<Eigen::Vector3d> taubinCircle(std::span<const Point> points) {
    if (points.size() < 3)
        return std::nullopt;
    const Point mean = meanOf(points);
    const auto n = static_cast<double>(points.size());
    double xx = 0.0, yy = 0.0, xy = 0.0, xz = 0.0, yz = 0.0, zz = 0.0;
    for (const Point& point : points) {
        const Point p = point - mean;
        const double z = p.squaredNorm();
        xx += p.x() * p.x() / n;
        yy += p.y() * p.y() / n;
        xy += p.x() * p.y() / n;
        xz += p.x() * z / n;
        yz += p.y() * z / n;
        zz += z * z / n;
    }
    const double z = xx + yy;
    const double determinant = xx * yy - xy * xy;
    if (determinant <= 1e-12 * z * z)
        return std::nullopt;
    // Newton's iteration for the smallest root of the characteristic polynomial, from 0 (converges from
    // below).
    const double variance = zz - z * z;
    const double a3 = 4.0 * z;
    const double a2 = -3.0 * z * z - zz;
    const double a1 = variance * z + 4.0 * determinant * z - xz * xz - yz * yz;
    const double a0 = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - variance * determinant;
    double root = 0.0;
    double value = a0;
    for (int iteration = 0; iteration < 30; ++iteration) {
        const double slope = a1 + root * (2.0 * a2 + 3.0 * a3 * root);
        if (slope == 0.0)
            break;
        const double next = root - value / slope;
        const double nextValue = a0 + next * (a1 + next * (a2 + next * a3));
        if (next == root || std::abs(nextValue) >= std::abs(value))
            break;
        root = next;
        value = nextValue;
    }
    const double denominator = 2.0 * (root * root - root * z + determinant);
    if (std::abs(denominator) <= 1e-12 * z * z)
        return std::nullopt;
    const Point centre = Point(xz * (yy - root) - yz * xy, yz * (xx - root) - xz * xy) / denominator;
    return Eigen::Vector3d(mean.x() + centre.x(), mean.y() + centre.y(), std::sqrt(centre.squaredNorm() + z));
}

CurvedLineFit fitLine(std::span<const Point> points) {
    const PointColumns columns(points);
    CurvedLineFit best;
    Eigen::Vector2d bestStart = Eigen::Vector2d::Zero();
    double bestLoss = std::numeric_limits<double>::infinity();
    const auto tryStart = [&](const Point& reference, const Eigen::Vector2d& start) {
        if (const double loss = lossOfStart(StraightModel(columns, reference), start); loss < bestLoss) {
            bestLoss = loss;
            best.curve.reference = reference;
            bestStart = start;
        }
    };
    const Point mean = meanOf(points);
    tryStart(mean, leastSquaresLine(points, mean));
    // Lines through points that are far apart in the order are not affected by an outlier that turns the
    // least-squares line.
    const std::size_t n = points.size();
    for (std::size_t quarter = 0; quarter < 3 && n >= 4; ++quarter) {
        const Point& a = points[quarter * n / 4];
        const Point& b = points[(quarter + 1) * n / 4];
        const Point along = b - a;
        if (along.norm() > 0.05)
            tryStart(a, Eigen::Vector2d(0.0, std::atan2(along.x(), -along.y())));
    }
    best.fit = fitRobustly(StraightModel(columns, best.curve.reference), bestStart);
    best.curve.d = best.fit.parameters[0];
    best.curve.theta_rad = best.fit.parameters[1];
    return best;
}

CurvedLineFit fitCurvedLine(std::span<const Point> points) {
    std::vector<CurvedLine> starts;
    const auto add = [&](const std::optional<Eigen::Vector3d>& circle) {
        if (circle && (*circle)[2] < 1e3)
            starts.push_back(fromCircle(points, *circle));
    };
    add(taubinCircle(points));
    const std::size_t n = points.size();
    const std::size_t step = std::max<std::size_t>(1, n / 8);
    for (std::size_t i = 0; i + 2 < n; i += step) {
        add(circleThrough(points[i], points[(i + n / 3) % n], points[(i + 2 * n / 3) % n]));
        if (i + n / 2 < n)
            add(circleThrough(points[i], points[i + n / 4], points[i + n / 2]));
    }
    const Point mean = meanOf(points);
    const Eigen::Vector2d line = leastSquaresLine(points, mean);
    starts.push_back({mean, 0.0, line[0], line[1]});

    const PointColumns columns(points);
    const auto parametersOf = [](const CurvedLine& s) { return Eigen::Vector3d(s.a, s.d, s.theta_rad); };
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const CurvedLine& s = starts[i];
        order.emplace_back(lossOfStart(CurvedModel(columns, s.reference), parametersOf(s)), i);
    }
    std::sort(order.begin(), order.end());

    CurvedLineFit best;
    for (std::size_t k = 0; k < std::min(kCurveStartsRefined, order.size()); ++k) {
        const CurvedLine& s = starts[order[k].second];
        const CurvedModel model(columns, s.reference);
        RobustFit fit = fitRoughly(model, parametersOf(s));
        if (k == 0 || robustLoss(fit) < robustLoss(best.fit)) {
            best.curve = {s.reference, fit.parameters[0], fit.parameters[1], fit.parameters[2]};
            best.fit = std::move(fit);
        }
    }
    best.fit = refined(CurvedModel(columns, best.curve.reference), best.fit);
    best.curve.a = best.fit.parameters[0];
    best.curve.d = best.fit.parameters[1];
    best.curve.theta_rad = best.fit.parameters[2];
    return best;
}

RobustFit fitEllipse(std::span<const Point> points, const CurvedLine& circle) {
    const PointColumns columns(points);
    const EllipseModel model(columns);
    const Point mean = meanOf(points);
    const double angle = leastSquaresLine(points, mean)[1] - 0.5 * std::numbers::pi;
    const Point axis(std::cos(angle), std::sin(angle));
    double along = 0.0;
    double across = 0.0;
    for (const Point& p : points) {
        along += std::pow((p - mean).dot(axis), 2) / static_cast<double>(points.size());
        across += std::pow(cross(axis, p - mean), 2) / static_cast<double>(points.size());
    }
    Eigen::VectorXd start(5);
    start << mean.x(), mean.y(), 0.5 * std::log(std::max(1e-4, 2.0 * along)),
        0.5 * std::log(std::max(1e-4, 2.0 * across)), angle;
    RobustFit best = fitRoughly(model, start);
    if (!circle.straight() && circle.radius() < 2.0) {
        const double logRadius = std::log(circle.radius());
        start << circle.centre().x(), circle.centre().y(), logRadius, logRadius, angle;
        if (RobustFit other = fitRoughly(model, start); robustLoss(other) < robustLoss(best))
            best = std::move(other);
    }
    return refined(model, best);
}

double ellipseLength(const Eigen::VectorXd& parameters) {
    // Ramanujan's first approximation; off by less than 0.1 % for a/b up to 3.
    const double a = std::exp(std::clamp(parameters[2], -20.0, 5.0));
    const double b = std::exp(std::clamp(parameters[3], -20.0, 5.0));
    return std::numbers::pi * (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b)));
}

std::vector<double> placesOnEllipse(std::span<const Point> points, const Eigen::VectorXd& parameters) {
    const double a = std::exp(std::clamp(parameters[2], -20.0, 5.0));
    const double b = std::exp(std::clamp(parameters[3], -20.0, 5.0));
    const Eigen::Rotation2Dd back(-parameters[4]);
    // Places of even angles; those between them are interpolated.
    constexpr int kSteps = 64;
    std::array<double, kSteps + 1> at{};
    const auto onEllipse = [&](int i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / kSteps;
        return Point(a * std::cos(angle_rad), b * std::sin(angle_rad));
    };
    for (int i = 1; i <= kSteps; ++i)
        at[static_cast<std::size_t>(i)] =
            at[static_cast<std::size_t>(i) - 1] + (onEllipse(i) - onEllipse(i - 1)).norm();
    const double scale = ellipseLength(parameters) / at.back();
    std::vector<double> places;
    places.reserve(points.size());
    for (const Point& point : points) {
        const Point p = back * (point - Point(parameters.head<2>()));
        const double turn = std::atan2(p.y() / b, p.x() / a) / (2.0 * std::numbers::pi) + 0.5;
        const double step = std::clamp(turn, 0.0, 1.0) * kSteps;
        const auto i = std::min<std::size_t>(static_cast<std::size_t>(step), kSteps - 1);
        places.push_back(scale * std::lerp(at[i], at[i + 1], step - static_cast<double>(i)));
    }
    return places;
}

} // namespace teleta::contour
