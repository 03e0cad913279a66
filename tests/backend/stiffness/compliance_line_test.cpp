// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/compliance_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace teleta::stiffness;

namespace {

// Points whose sums are easy: means 2, S_xx = 10, S_yy = 10.8, S_xy = 9.8 (x = torque, y = angle).
const std::vector<TorqueAngle> kPoints{{0.0, 0.2}, {1.0, 0.8}, {2.0, 2.0}, {3.0, 2.8}, {4.0, 4.2}};

double squaresXx() {
    return 10.0;
}
double squaresYy() {
    return 1.8 * 1.8 + 1.2 * 1.2 + 0.0 + 0.8 * 0.8 + 2.2 * 2.2;
}
double squaresXy() {
    return 2.0 * 1.8 + 1.0 * 1.2 + 0.0 + 1.0 * 0.8 + 2.0 * 2.2;
}

} // namespace

TEST(ComplianceLine, allNoiseInTheAngleIsLeastSquaresOfAngleOnTorque) {
    const auto line = fitComplianceLine(kPoints, {0.0, 0.1});
    ASSERT_TRUE(line);
    const double slope = squaresXy() / squaresXx();
    EXPECT_NEAR(line->slope_radPerNm, slope, 1e-14);
    EXPECT_NEAR(line->offset_rad, 2.0 - slope * 2.0, 1e-14);
    const double variance = (squaresYy() - slope * squaresXy()) / 3.0;
    EXPECT_NEAR(line->slopeSe_radPerNm.value(), std::sqrt(variance / squaresXx()), 1e-13);
    EXPECT_NEAR(line->torqueSpread_Nm, std::sqrt(squaresXx()), 1e-13);
}

TEST(ComplianceLine, allNoiseInTheTorqueIsLeastSquaresOfTorqueOnAngle) {
    const auto line = fitComplianceLine(kPoints, {0.1, 0.0});
    ASSERT_TRUE(line);
    const double inverse = squaresXy() / squaresYy();
    EXPECT_NEAR(line->slope_radPerNm, 1.0 / inverse, 1e-14);
    const double variance = (squaresXx() - inverse * squaresXy()) / 3.0;
    EXPECT_NEAR(line->slopeSe_radPerNm.value(), std::sqrt(variance / squaresYy()) / inverse / inverse, 1e-13);
}

TEST(ComplianceLine, noiseThatIsNotKnownCountsAsNoiseOfTheTorque) {
    EXPECT_EQ(fitComplianceLine(kPoints, {0.0, 0.0})->slope_radPerNm,
              fitComplianceLine(kPoints, {1.0, 0.0})->slope_radPerNm);
}

TEST(ComplianceLine, equalNoiseIsTheDirectionOfTheLargestVariance) {
    // Orthogonal regression: tan(2 angle) = 2 S_xy / (S_xx - S_yy).
    const auto line = fitComplianceLine(kPoints, {0.3, 0.3});
    ASSERT_TRUE(line);
    double direction_rad = 0.5 * std::atan2(2.0 * squaresXy(), squaresXx() - squaresYy());
    EXPECT_NEAR(line->slope_radPerNm, std::tan(direction_rad), 1e-13);
}

TEST(ComplianceLine, pearsonsPointsGiveHisSlope) {
    // Pearson (1901), "On lines and planes of closest fit": slope -0.54556 through the centroid (3.82, 3.70).
    const std::vector<TorqueAngle> points{{0.0, 5.9}, {0.9, 5.4}, {1.8, 4.4}, {2.6, 4.6}, {3.3, 3.5},
                                          {4.4, 3.7}, {5.2, 2.8}, {6.1, 2.8}, {6.5, 2.4}, {7.4, 1.5}};
    const auto line = fitComplianceLine(points, {1.0, 1.0});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->slope_radPerNm, -0.54556, 5e-6);
    EXPECT_NEAR(line->offset_rad, 3.70 + 0.54556 * 3.82, 5e-5);
}

TEST(ComplianceLine, onlyTheRatioOfTheNoiseMovesTheLine) {
    const auto one = fitComplianceLine(kPoints, {1e-3, 2e-3});
    const auto thousand = fitComplianceLine(kPoints, {1.0, 2.0});
    EXPECT_NEAR(one->slope_radPerNm, thousand->slope_radPerNm, 1e-14);
    EXPECT_NEAR(*one->slopeSe_radPerNm, *thousand->slopeSe_radPerNm, 1e-14);
}

TEST(ComplianceLine, fittedTorqueIsTheFootOfTheLikeliestError) {
    const ReadingNoise noise{0.2, 0.1};
    const auto line = fitComplianceLine(kPoints, noise);
    ASSERT_TRUE(line);
    for (const TorqueAngle& point : kPoints) {
        const double fitted_Nm = line->fittedTorque_Nm(point);
        // The foot minimises ((torque - t)/0.2)^2 + ((angle - line(t))/0.1)^2: derivative zero.
        const double angle_rad = line->offset_rad + line->slope_radPerNm * fitted_Nm;
        const double derivative = (point.torque_Nm - fitted_Nm) / 0.04 +
                                  line->slope_radPerNm * (point.angle_rad - angle_rad) / 0.01;
        EXPECT_NEAR(derivative, 0.0, 1e-10);
    }
}

TEST(ComplianceLine, twoPointsGiveALineWithoutAStandardError) {
    const auto line = fitComplianceLine(std::vector<TorqueAngle>{{1.0, 1.0}, {2.0, 4.0}}, {1.0, 0.0});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->slope_radPerNm, 3.0, 1e-14);
    EXPECT_FALSE(line->slopeSe_radPerNm);
}

TEST(ComplianceLine, pointsOfOneTorqueOrFewerThanTwoPointsHaveNoLine) {
    EXPECT_FALSE(fitComplianceLine({}, {}));
    EXPECT_FALSE(fitComplianceLine(std::vector<TorqueAngle>{{1.0, 1.0}}, {}));
    EXPECT_FALSE(fitComplianceLine(std::vector<TorqueAngle>{{1.0, 1.0}, {1.0, 2.0}, {1.0, 3.0}}, {}));
}

TEST(ComplianceLine, aConstantAngleHasSlopeZeroAndNoError) {
    const auto line =
        fitComplianceLine(std::vector<TorqueAngle>{{1.0, 5.0}, {2.0, 5.0}, {3.0, 5.0}}, {1.0, 0.0});
    ASSERT_TRUE(line);
    EXPECT_EQ(line->slope_radPerNm, 0.0);
    EXPECT_EQ(line->slopeSe_radPerNm, 0.0);
    EXPECT_FALSE(line->correlated);
}

TEST(ComplianceLine, readingsThatDoNotCorrelateGiveASlopeAboutZero) {
    const std::vector<TorqueAngle> points{{-1.0, 1.0}, {0.0, -2.0}, {1.0, 1.0}};
    const auto line = fitComplianceLine(points, {1.0, 0.0});
    ASSERT_TRUE(line);
    EXPECT_FALSE(line->correlated);
    EXPECT_NEAR(line->slope_radPerNm, 0.0, 1e-15);
    EXPECT_NEAR(line->slopeSe_radPerNm.value(), std::sqrt(6.0 / 1.0 / 2.0), 1e-14);
}

TEST(ComplianceLine, studentQuantilesAreThoseOfTheTables) {
    EXPECT_NEAR(studentQuantile95(1.0), 12.7062, 1e-4);
    EXPECT_NEAR(studentQuantile95(10.0), 2.22814, 1e-5);
    EXPECT_NEAR(studentQuantile95(1e6), 1.959964, 1e-5);
}
