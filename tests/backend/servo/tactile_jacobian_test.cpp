// SPDX-License-Identifier: GPL-3.0-or-later
// The errata of the tactile servoing paper have a test each here; their numbers are those of the
// specification.
#include "backend/servo/tactile_jacobian.h"
#include "tests/backend/servo/servo_frames.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace teleta::servo;
using namespace teleta::servo::test;
using teleta::contact::ContactType;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPitch_m = 0.0034;

Matrix6 matrix(std::initializer_list<double> rows) {
    Matrix6 m;
    int i = 0;
    for (const double value : rows) {
        m(i / 6, i % 6) = value;
        ++i;
    }
    return m;
}

} // namespace

TEST(ServoErrata, oneTheCovarianceRunsOverTheTaxelsInContact) {
    // n taxels in a row: variance of the coordinates with n - 1 in the denominator is p^2 n (n + 1)/12.
    Bed bed;
    for (int column = 3; column < 11; ++column)
        bed.at(2, column) = 1.0F;
    const auto line = bed.features();
    EXPECT_NEAR(*line.lambda1_m2, kPitch_m * kPitch_m * 8.0 * 9.0 / 12.0, 1e-15);
    EXPECT_NEAR(*line.lambda2_m2, 0.0, 1e-15);
    bed.clear();
    bed.at(2, 5) = 1.0F;
    EXPECT_FALSE(bed.features().alphaZ_rad.has_value());
}

TEST(ServoErrata, twoWithTheRightOrderRowsFourAndFiveAreMinusDzmp) {
    const auto f = feel(ContactType::edge, 5.0, 0.004, -0.001, 0.001, 0.002, 0.1);
    const Vector6 actual = inverseTactileJacobian(true) * featureVector(f, 1e-3).s;
    EXPECT_DOUBLE_EQ(actual[kWx], -*f.dzmpX_m);
    EXPECT_DOUBLE_EQ(actual[kWy], -*f.dzmpY_m);
    // In the order that the paper prints, row 4 would mix the axes.
    FeatureVector printed = featureVector(f, 1e-3).s;
    std::swap(printed[3], printed[4]);
    EXPECT_DOUBLE_EQ((inverseTactileJacobian(true) * printed)[kWx], *f.cocX_m - *f.copY_m);
}

TEST(ServoErrata, twoMoreLoadAtPlusXTurnsTheSensorAboutPlusY) {
    // About +y a point at +x of the sensor goes to -z, away from the object.
    ServoController controller = controllerOf(edgeControlTask(5.0));
    Bed bed;
    const auto f = bed.bar(0.4, 4.0);
    ASSERT_GT(*f.dzmpY_m, 0.0005);
    const ServoOutput out = controller.step(inputOf(f));
    EXPECT_GT(out.twist_Sensor[kWy], 0.0);
    const Eigen::Vector3d atPlusX = out.twist_Sensor.tail<3>().cross(Eigen::Vector3d(0.02, 0.0, 0.0));
    EXPECT_LT(atPlusX.z(), 0.0);
}

TEST(ServoErrata, threeInPhaseFourTheErrorOfCopXMovesTheSensor) {
    const ServoTask explore = exploreTask(5.0, 0.005);
    EXPECT_EQ(projectionMatrix(explore.projection), matrix({1, 0, 0, 0, 0, 0, //
                                                            0, 1, 0, 0, 0, 0, //
                                                            0, 0, 1, 0, 0, 0, //
                                                            0, 0, 0, 0, 0, 0, //
                                                            0, 0, 0, 0, 1, 0, //
                                                            0, 0, 0, 0, 0, 1}));
    ServoController controller = controllerOf(explore);
    const ServoOutput out = controller.step(inputOf(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0)));
    EXPECT_NEAR(out.twist_Sensor[kX], 0.005, 1e-15);
}

TEST(ServoErrata, fourTheEdgeAlongXTurnsAboutYAndNotAboutX) {
    for (const ServoTask& task : {alignTask(5.0), edgeControlTask(5.0), exploreTask(5.0, 0.005)}) {
        EXPECT_TRUE(task.projection.wy) << toString(task.kind);
        EXPECT_FALSE(task.projection.wx) << toString(task.kind);
    }
}

TEST(ServoErrata, fiveGammaComIsInColumnFive) {
    const ServoTask task = comanipulationTask(6.0);
    EXPECT_EQ(projectionMatrix(task.projection), matrix({0, 0, 0, 0, 1, 0, //
                                                         0, 1, 0, 0, 0, 0, //
                                                         0, 0, 1, 0, 0, 0, //
                                                         0, 0, 0, 0, 0, 0, //
                                                         0, 0, 0, 0, 0, 0, //
                                                         0, 0, 0, 0, 0, 1}));
    // DZMP_y moves the sensor along x, below the load, and does not turn it.
    ServoController controller = controllerOf(task);
    const ServoOutput out = controller.step(inputOf(feel(ContactType::edge, 6.0, 0.003, 0.0, 0.0, 0.0)));
    EXPECT_NEAR(out.twist_Sensor[kX], task.gains.proportional[kX] * 0.003, 1e-15);
    EXPECT_EQ(out.twist_Sensor[kWy], 0.0);
    // DZMP_x does not move it along x, as column 4 would.
    controller.reset();
    const ServoOutput other = controller.step(inputOf(feel(ContactType::edge, 6.0, 0.0, 0.0, 0.0, 0.002)));
    EXPECT_EQ(other.twist_Sensor[kX], 0.0);
}

TEST(ServoErrata, sixFullScaleIsThePressureTimesTheArea) {
    const double area_mm2 = 3.4 * 3.4;
    EXPECT_NEAR(0.25 * area_mm2, 2.89, 1e-12);
    EXPECT_DOUBLE_EQ(*ServoLimits{}.saturation_N, 2.89);
    EXPECT_NEAR(2.0 / (kPi * 0.25), 2.55, 0.005); // what 2 N over a disc of 1 mm is, in N/mm^2
}

TEST(TactileJacobian, matricesAreThoseOfEquationsSixteenAndSeventeen) {
    EXPECT_EQ(inverseTactileJacobian(false), matrix({1, 0, 0, 0, 0, 0, //
                                                     0, 1, 0, 0, 0, 0, //
                                                     0, 0, 1, 0, 0, 0, //
                                                     0, 0, 0, 1, 0, 0, //
                                                     0, 0, 0, 0, 1, 0, //
                                                     0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(inverseTactileJacobian(true), matrix({1,  0,  0, 0, 0, 0, //
                                                    0,  1,  0, 0, 0, 0, //
                                                    0,  0,  1, 0, 0, 0, //
                                                    0,  -1, 0, 1, 0, 0, //
                                                    -1, 0,  0, 0, 1, 0, //
                                                    0,  0,  0, 0, 0, 1}));
    EXPECT_EQ(projectionMatrix(alignTask(5.0).projection), matrix({0, 0, 0, 0, 0, 0, //
                                                                   0, 1, 0, 0, 0, 0, //
                                                                   0, 0, 1, 0, 0, 0, //
                                                                   0, 0, 0, 0, 0, 0, //
                                                                   0, 0, 0, 0, 1, 0, //
                                                                   0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(projectionMatrix(edgeControlTask(5.0).projection), matrix({0, 0, 0, 0, 0, 0, //
                                                                         0, 1, 0, 0, 0, 0, //
                                                                         0, 0, 1, 0, 0, 0, //
                                                                         0, 0, 0, 0, 0, 0, //
                                                                         0, 0, 0, 0, 1, 0, //
                                                                         0, 0, 0, 0, 0, 1}));
    EXPECT_EQ(projectionMatrix(freeMotion().projection), Matrix6(Matrix6::Zero()));
}

TEST(TactileJacobian, aFeatureThatIsNotDefinedIsMarked) {
    Bed bed;
    bed.at(2, 5) = 1.0F;
    const MeasuredFeatures measured = featureVector(bed.features(), 2e-3);
    EXPECT_TRUE(measured.defined[kX]);
    EXPECT_FALSE(measured.defined[kWz]);
    EXPECT_DOUBLE_EQ(measured.s[kZ], 2e-3);
}

TEST(EdgeDirection, atNinetyDegreesNoiseDoesNotTurnTheError) {
    // The axis flips between +90 and -90 degrees; the direction that is followed does not.
    EdgeDirection direction;
    const double first = direction.follow(kPi / 2.0, 0.0);
    for (int frame = 0; frame < 100; ++frame) {
        const double noise = 0.05 * std::sin(1.7 * frame);
        double alpha = kPi / 2.0 + noise;
        if (alpha > kPi / 2.0)
            alpha -= kPi;
        EXPECT_NEAR(direction.follow(alpha, 0.0), first, 0.051);
    }
}

TEST(EdgeDirection, beyondTheMarginTheShorterWayIsTaken) {
    EdgeDirection direction;
    double alpha = 0.0;
    double error = 0.0;
    int jumps = 0;
    for (int step = 0; step < 400; ++step) {
        alpha = 0.01 * step; // an edge that keeps turning
        const double before = error;
        error = -direction.follow(std::remainder(alpha, kPi), 0.0);
        EXPECT_LE(std::abs(error), kPi / 2.0 + EdgeDirection::kMargin_rad + 0.011);
        EXPECT_NEAR(std::remainder(error + alpha, kPi), 0.0, 1e-12);
        if (std::abs(error - before) > 0.1)
            ++jumps;
    }
    // Over 4 rad there is one change of the branch, at 90 + 15 degrees.
    EXPECT_EQ(jumps, 1);
}

TEST(EdgeDirection, theFirstFrameTakesTheBranchNearestToWhatIsWanted) {
    EXPECT_NEAR(EdgeDirection().follow(-1.5, 1.5), kPi - 1.5, 1e-15);
    EXPECT_NEAR(EdgeDirection().follow(-0.3, 0.0), -0.3, 1e-15);
}
