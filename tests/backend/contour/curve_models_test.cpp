// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/curve_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace teleta::contour {

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
