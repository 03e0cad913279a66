// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/curve_models.h"
#include "tests/backend/contour/contour_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace teleta::contour {

namespace {

/// Distance of a point from the curve of these parameters, as the models define it.
using Distance = std::function<double(const Point&, const Eigen::VectorXd&)>;

/// The residuals are these distances, and the Jacobian is their slope.
void expectTheSlopesOf(const RobustFit& fit, const Points& points, const Distance& distance) {
    constexpr double kStep = 1e-6;
    ASSERT_EQ(fit.residuals.size(), static_cast<Eigen::Index>(points.size()));
    EXPECT_GT(fit.residuals.cwiseAbs().maxCoeff(), 0.01) << "far from the curve all terms count";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(fit.residuals[row], distance(points[i], fit.parameters), 1e-12) << i;
        for (Eigen::Index k = 0; k < fit.parameters.size(); ++k) {
            Eigen::VectorXd more = fit.parameters;
            Eigen::VectorXd less = fit.parameters;
            more[k] += kStep;
            less[k] -= kStep;
            const double slope = (distance(points[i], more) - distance(points[i], less)) / (2.0 * kStep);
            EXPECT_NEAR(fit.jacobian(row, k), slope, 1e-7) << "point " << i << ", parameter " << k;
        }
    }
}

Points scattered(Points points, double noise, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, noise);
    for (Point& p : points)
        p += Point(normal(random), normal(random));
    return points;
}

} // namespace

TEST(FitEllipse, hasTheDerivativesOfACircleWhereItIsOne) {
    // On a circle of radius R a point at the angle t moves away by dR = -(cos t dx + sin t dy), and by
    // -R cos^2 (t - angle) and -R sin^2 (t - angle) when the logarithm of one axis grows.
    constexpr int kPoints = 24;
    constexpr double kRadius = 0.5;
    std::vector<Point> points;
    for (int i = 0; i < kPoints; ++i) {
        const double t_rad = 2.0 * std::numbers::pi * i / kPoints;
        points.emplace_back(0.1 + kRadius * std::cos(t_rad), -0.2 + kRadius * std::sin(t_rad));
    }
    const CurvedLineFit circle = fitCurvedLine(points);
    const RobustFit fit = fitEllipse(points, circle.curve);
    ASSERT_LT(fit.residuals.cwiseAbs().maxCoeff(), 1e-9);
    for (int i = 0; i < kPoints; ++i) {
        const double t_rad = 2.0 * std::numbers::pi * i / kPoints;
        const double along = std::cos(t_rad - fit.parameters[4]);
        const double across = std::sin(t_rad - fit.parameters[4]);
        EXPECT_NEAR(fit.jacobian(i, 0), -std::cos(t_rad), 1e-6) << i;
        EXPECT_NEAR(fit.jacobian(i, 1), -std::sin(t_rad), 1e-6) << i;
        EXPECT_NEAR(fit.jacobian(i, 2), -kRadius * along * along, 1e-6) << i;
        EXPECT_NEAR(fit.jacobian(i, 3), -kRadius * across * across, 1e-6) << i;
        EXPECT_NEAR(fit.jacobian(i, 4), 0.0, 1e-6) << i;
    }
}

TEST(FitEllipse, hasTheSlopesOfItsDistances) {
    Points points = circlePoints(31);
    for (Point& p : points)
        p = Point(0.5 * p.x(), 0.25 * p.y());
    points = scattered(moved(points, 1.0, 0.6, {0.03, -0.05}), 0.02, 3);
    const RobustFit fit = fitEllipse(points, fitCurvedLine(points).curve);
    EXPECT_NEAR(std::abs(fit.parameters[2] - fit.parameters[3]), std::log(2.0), 0.2);
    // (level - 1) / |gradient of the level|, the level being 1 on the ellipse.
    expectTheSlopesOf(fit, points, [](const Point& point, const Eigen::VectorXd& p) {
        const Point axes(std::exp(p[2]), std::exp(p[3]));
        const Point scaled = rotated(point - Point(p.head<2>()), -p[4]).cwiseQuotient(axes);
        const double level = scaled.norm();
        return (level - 1.0) / (scaled.cwiseQuotient(axes) / level).norm();
    });
}

TEST(FitCurvedLine, hasTheSlopesOfItsDistances) {
    for (const double radius : {0.4, 2.0}) {
        Points points;
        for (int i = 0; i < 29; ++i)
            points.push_back(onCircle(radius, 0.3 + 0.5 / radius * i / 28.0) - onCircle(radius, 0.4));
        points = scattered(points, 0.015, 4);
        const CurvedLineFit found = fitCurvedLine(points);
        ASSERT_FALSE(found.curve.straight());
        // Outside of the circle positive where A is.
        expectTheSlopesOf(found.fit, points, [&](const Point& point, const Eigen::VectorXd& p) {
            const CurvedLine curve{found.curve.reference, p[0], p[1], p[2]};
            return std::copysign(1.0, p[0]) * ((point - curve.centre()).norm() - curve.radius());
        });
    }
}

TEST(FitRobustly, weighsEachPointInTheNormalMatrix) {
    Eigen::MatrixXd jacobian(3, 2);
    jacobian << 1.0, 2.0, -3.0, 0.5, 4.0, -1.0;
    const NormalMatrix normal = normalMatrix(jacobian, Eigen::Vector3d(1.0, 2.0, 0.5));
    // 1 + 2 * 9 + 0.5 * 16, 2 - 2 * 1.5 - 0.5 * 4, 4 + 2 * 0.25 + 0.5
    EXPECT_EQ(normal(0, 0), 27.0);
    EXPECT_EQ(normal(0, 1), -3.0);
    EXPECT_EQ(normal(1, 0), -3.0);
    EXPECT_EQ(normal(1, 1), 5.0);
}

} // namespace teleta::contour
