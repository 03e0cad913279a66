// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/polygon_models.h"
#include "backend/contour/polyline_model.h"
#include "tests/backend/contour/contour_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace teleta::contour {

namespace {

Points scatteredAbout(const Points& curve, double noise, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, noise);
    Points points;
    for (const Point& p : curve)
        points.push_back(p + Point(normal(random), normal(random)));
    return points;
}

Points alongBox(double width, double height, int points) {
    Points all;
    const double perimeter = 2.0 * (width + height);
    for (int i = 0; i < points; ++i) {
        double s = perimeter * i / points;
        Point p(-0.5 * width, -0.5 * height);
        for (const Point& edge :
             {Point(width, 0.0), Point(0.0, height), Point(-width, 0.0), Point(0.0, -height)}) {
            const double step = std::min(s, edge.norm());
            p += step * edge.normalized();
            s -= step;
        }
        all.push_back(p);
    }
    return all;
}

Eigen::VectorXd distances(const Points& points, const Eigen::VectorXd& vertices) {
    const PointColumns columns(points);
    return PolylineModel(columns, true).fitAt(vertices).residuals;
}

/// The distances are those from the polygon's edges, and the Jacobian is their slope.
void expectTheSlopesOf(const PolygonFit& found, const Points& points,
                       const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& verticesOf) {
    constexpr double kStep = 1e-6;
    const Eigen::VectorXd here = distances(points, verticesOf(found.fit.parameters));
    EXPECT_LT((here - found.fit.residuals).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(here.cwiseAbs().maxCoeff(), 0.005);
    for (Eigen::Index k = 0; k < found.fit.parameters.size(); ++k) {
        Eigen::VectorXd more = found.fit.parameters;
        Eigen::VectorXd less = more;
        more[k] += kStep;
        less[k] -= kStep;
        const Eigen::VectorXd slope =
            (distances(points, verticesOf(more)) - distances(points, verticesOf(less))) / (2.0 * kStep);
        EXPECT_LT((slope - found.fit.jacobian.col(k)).cwiseAbs().maxCoeff(), 1e-5) << "parameter " << k;
    }
}

} // namespace

TEST(PolygonModels, aRectangleHasTheDistancesOfItsEdgesAndTheirSlopes) {
    const Points points = moved(scatteredAbout(alongBox(0.9, 0.5, 43), 0.02, 5), 1.0, 0.4, {0.02, -0.03});
    const PolygonFit found = fitRectangle(points, {});
    const auto verticesOf = [](const Eigen::VectorXd& p) {
        Eigen::VectorXd vertices(8);
        const Points corners{{-p[3], -p[4]}, {p[3], -p[4]}, {p[3], p[4]}, {-p[3], p[4]}};
        for (Eigen::Index i = 0; i < 4; ++i)
            vertices.segment<2>(2 * i) =
                rotated(corners[static_cast<std::size_t>(i)], p[2]) + Point(p.head<2>());
        return vertices;
    };
    expectTheSlopesOf(found, points, verticesOf);
    EXPECT_NEAR(found.fit.parameters[3] * found.fit.parameters[4], 0.25 * 0.9 * 0.5, 0.01);
}

TEST(PolygonModels, aRegularPolygonHasTheDistancesOfItsEdgesAndTheirSlopes) {
    for (const int sides : {5, 6}) {
        const Points points = moved(scatteredAbout(circlePoints(41, 0.5), 0.02, 6), 1.0, 0.2, {0.01, 0.04});
        const PolygonFit found = fitRegularPolygon(points, sides, {0.01, 0.04}, 0.5);
        const auto verticesOf = [sides](const Eigen::VectorXd& p) {
            Eigen::VectorXd vertices(2 * sides);
            for (Eigen::Index i = 0; i < sides; ++i)
                vertices.segment<2>(2 * i) =
                    onCircle(std::exp(p[2]), p[3] + 2.0 * std::numbers::pi * static_cast<double>(i) / sides) +
                    Point(p.head<2>());
            return vertices;
        };
        expectTheSlopesOf(found, points, verticesOf);
    }
}

TEST(PolylineModel, placesAreOfChainsOfAtMostSoManyCoordinates) {
    // Along the x axis, vertices one apart; a point above the middle of the last edge.
    const auto chain = [](Eigen::Index numbers) {
        Eigen::VectorXd vertices = Eigen::VectorXd::Zero(numbers);
        for (Eigen::Index i = 0; 2 * i < numbers; ++i)
            vertices[2 * i] = static_cast<double>(i);
        return vertices;
    };
    for (const Eigen::Index vertices : {2, 17}) {
        const double middle = static_cast<double>(vertices) - 1.5;
        const Points above{{middle, 0.25}, {0.25, 0.5}};
        EXPECT_EQ(placesOnPolyline(above, chain(2 * vertices), false), (std::vector{middle, 0.25}));
        EXPECT_EQ(waysOnPolyline(above, chain(2 * vertices), false), (std::vector{middle, 0.25}));
    }
    const Points points{{0.0, 0.25}, {0.25, 0.5}, {3.0, 3.0}};
    for (const Eigen::Index numbers : {0, 1, 2, 3, 5, kMostParameters + 1, kMostParameters + 2, 400})
        for (const bool closed : {false, true})
            for (const std::vector<double>& none : {placesOnPolyline(points, chain(numbers), closed),
                                                    waysOnPolyline(points, chain(numbers), closed)}) {
                ASSERT_EQ(none.size(), points.size()) << numbers;
                EXPECT_TRUE(std::ranges::all_of(none, [](double place) { return std::isnan(place); }))
                    << numbers;
            }
}

TEST(PolylineModel, itsEquationsAreThoseOfItsJacobian) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(-0.6, 0.6);
    for (const bool closed : {false, true})
        for (const Eigen::Index vertices : {3, 4, 7, 17}) {
            Points points;
            for (int i = 0; i < 38; ++i)
                points.emplace_back(place(random), place(random));
            const PointColumns columns(points);
            const PolylineModel model(columns, closed);
            RobustModel::At at;
            at.parameters.resize(2 * vertices);
            for (double& number : at.parameters)
                number = place(random);
            model.evaluate(at);
            std::vector<double> weights(columns.filled(), 0.0);
            std::vector<double> weightedResiduals(columns.filled(), 0.0);
            for (std::size_t i = 0; i < points.size(); ++i) {
                weights[i] = 0.6 + place(random);
                weightedResiduals[i] = weights[i] * at.residuals[i];
            }
            StepEquations equations;
            model.equations(at, weights.data(), weightedResiduals.data(), equations);
            const Eigen::MatrixXd jacobian = model.jacobian(at);
            const Eigen::Map<const Eigen::VectorXd> w(weights.data(), jacobian.rows());
            const Eigen::Map<const Eigen::VectorXd> wr(weightedResiduals.data(), jacobian.rows());
            const Eigen::MatrixXd normal = jacobian.transpose() * w.asDiagonal() * jacobian;
            const Eigen::VectorXd gradient = jacobian.transpose() * wr;
            ASSERT_EQ(equations.count, 2 * vertices);
            for (int column = 0; column < equations.count; ++column) {
                EXPECT_NEAR(equations.gradient[static_cast<std::size_t>(column)], gradient[column], 1e-12);
                for (int row = 0; row <= column; ++row) {
                    const bool within = row >= equations.first[static_cast<std::size_t>(column)];
                    EXPECT_NEAR(within ? equations.at(row, column) : 0.0, normal(row, column), 1e-12)
                        << row << ", " << column << (closed ? ", closed" : ", open");
                }
            }
        }
}

} // namespace teleta::contour
