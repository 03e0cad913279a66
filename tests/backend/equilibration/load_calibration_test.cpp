// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/load_calibration.h"
#include "backend/equilibration/load_calibration_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace teleta;
using equilibration::findLoadCalibration;
using equilibration::KnownPresses;
using equilibration::LoadCalibration;

namespace {

/// Nine presses with noise, and what numpy 1.24 makes of them: linalg.lstsq, and the root of
/// RSS / 6 times the diagonal of inv(X'X).
struct Peer {
    KnownPresses presses;
    Eigen::Matrix3d gain, error;
};

Peer peer() {
    Peer peer;
    peer.presses.loads = {"force_n", "shear_x_n", "shear_y_n"};
    peer.presses.channels = {"a", "b", "c"};
    peer.presses.signal.resize(9, 3);
    peer.presses.load.resize(9, 3);
    peer.presses.signal << -8.0, -18.1, -6.5, 4.2, 13.9, 4.5, -5.5, -11.2, 5.1, 16.3, 12.5, -11.5, -9.6, 10.3,
        6.8, -17.3, -11.2, -11.9, -6.3, -8.7, -8.6, 5.5, 2.7, -6.1, 4.1, 10.8, -13.9;
    peer.presses.load << -1.6, -2.89, -1.26, 0.78, 2.18, 0.85, -1.38, -1.63, 0.84, 3.68, 1.58, -1.9, -2.08,
        1.74, 1.16, -3.31, -1.9, -2.37, -1.09, -1.47, -1.71, 1.3, 0.27, -0.99, 1.29, 1.38, -2.52;
    peer.gain << 0.2041969575387435, 0.006439410413586531, -0.026692916369861715, -0.00410072024075654,
        0.15336521860268318, 0.020005361726347995, 0.0118715240078449, 0.00022000317500384461,
        0.1829931128566354;
    peer.error << 0.0016421085129048009, 0.0013723124779617092, 0.001359176343254409, 0.0012978919497139097,
        0.0010846501943332335, 0.0010742676383979969, 0.0019837036369415267, 0.0016577840210677361,
        0.0016419152779308228;
    return peer;
}

std::string whyNot(const KnownPresses& presses) {
    const auto found = findLoadCalibration(presses);
    EXPECT_FALSE(found);
    return found ? "" : found.error().message;
}

} // namespace

TEST(LoadCalibration, isNumpysLeastSquares) {
    const Peer expected = peer();
    const auto found = findLoadCalibration(expected.presses);
    ASSERT_TRUE(found);
    EXPECT_LT((found->gain - expected.gain).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((found->error - expected.error).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_TRUE(found->rest.isZero(0.0));
}

/// One signal: the gain is sum(xy) / sum(xx), its error the residuals' deviation over the root of sum(xx).
TEST(LoadCalibration, ofOneSignalIsASlopeFromItsRest) {
    KnownPresses presses{.loads = {"force_n"}, .channels = {"field_ut"}, .load{}, .signal{}};
    presses.load.resize(7, 1);
    presses.signal.resize(7, 1);
    // Two rows without load have 100 and 102 as signal: the rest is 101.
    presses.load << 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0;
    presses.signal << 100.0, 102.0, 103.0, 105.0, 107.0, 109.0, 112.0;
    const auto found = findLoadCalibration(presses);
    ASSERT_TRUE(found);
    const double xx = 4.0 + 16.0 + 36.0 + 64.0 + 121.0;
    const double slope = (2.0 + 8.0 + 18.0 + 32.0 + 55.0) / xx;
    double squares = 0.0;
    for (const auto& [x, y] : {std::pair{2.0, 1.0}, {4.0, 2.0}, {6.0, 3.0}, {8.0, 4.0}, {11.0, 5.0}})
        squares += (y - slope * x) * (y - slope * x);
    EXPECT_NEAR(found->gain(0, 0), slope, 1e-14);
    EXPECT_NEAR(found->error(0, 0), std::sqrt(squares / 4.0 / xx), 1e-14);
    EXPECT_EQ(found->rest[0], 101.0);
    EXPECT_EQ(found->least[0], 100.0);
    EXPECT_EQ(found->greatest[0], 112.0);
    EXPECT_NEAR(found->at(Eigen::VectorXd::Constant(1, 111.0)).loads[0], 10.0 * slope, 1e-13);
    // Of one signal the bound is the error of a prediction: s sqrt(1 + x^2 / sum(xx)).
    EXPECT_NEAR(found->at(Eigen::VectorXd::Constant(1, 111.0)).errors[0],
                std::sqrt(squares / 4.0 * (1.0 + 100.0 / xx)), 1e-13);
    EXPECT_FALSE(found->at(Eigen::VectorXd::Constant(1, 112.0)).extrapolated);
    EXPECT_TRUE(found->at(Eigen::VectorXd::Constant(1, 112.1)).extrapolated);
    EXPECT_TRUE(found->at(Eigen::VectorXd::Constant(1, 99.9)).extrapolated);
    EXPECT_FALSE(found->at(Eigen::VectorXd::Constant(1, std::nan(""))).extrapolated) << "there is no load";
}

/// The exact error of a prediction is s sqrt(1 + x' inv(X'X) x); the bound is not below it.
TEST(LoadCalibration, errorsAreNotBelowThoseOfAPrediction) {
    const KnownPresses presses = peer().presses;
    const auto found = findLoadCalibration(presses);
    ASSERT_TRUE(found);
    const Eigen::Matrix3d inverse = (presses.signal.transpose() * presses.signal).inverse();
    for (const Eigen::Vector3d& x : {Eigen::Vector3d(5.0, -3.0, 2.0), Eigen::Vector3d(-12.0, 10.0, 4.0),
                                     Eigen::Vector3d(0.0, 0.0, -9.0), Eigen::Vector3d(0.0, 0.0, 0.0)}) {
        const Eigen::VectorXd errors = found->at(x).errors;
        for (Eigen::Index load = 0; load < 3; ++load) {
            const double exact = found->scatter[load] * std::sqrt(1.0 + x.dot(inverse * x));
            EXPECT_GE(errors[load], exact - 1e-12);
            EXPECT_LE(errors[load], 2.0 * exact);
        }
    }
}

TEST(LoadCalibration, refusesWhatThePressesDoNotDetermine) {
    KnownPresses few = peer().presses;
    few.load = few.load.topRows(5).eval();
    few.signal = few.signal.topRows(5).eval();
    EXPECT_EQ(whyNot(few), "5 presses under load are too few for 3 signals");
    KnownPresses unloaded = peer().presses;
    unloaded.load.setZero();
    EXPECT_EQ(whyNot(unloaded), "0 presses under load are too few for 3 signals");
    KnownPresses level = peer().presses;
    level.load.col(1).setConstant(2.0);
    EXPECT_EQ(whyNot(level), "shear_x_n is the same in all presses");
    KnownPresses silent = peer().presses;
    silent.signal.col(2).setConstant(4.0);
    EXPECT_EQ(whyNot(silent), "c is the same in all presses");
    KnownPresses alike = peer().presses;
    alike.signal.col(2) = 3.0 * alike.signal.col(0);
    EXPECT_EQ(whyNot(alike), "the presses do not tell the signals apart");
    // The size of a signal does not matter, only its direction.
    KnownPresses small = peer().presses;
    small.signal.col(2) *= 1e-9;
    const auto found = findLoadCalibration(small);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->gain(0, 2) * 1e-9, peer().gain(0, 2), 1e-12);
}

TEST(LoadCalibrationFile, isReadAsItWasWritten) {
    const test::TemporaryFolder folder;
    const auto found = findLoadCalibration(peer().presses);
    ASSERT_TRUE(found);
    const std::string path = folder.path("new/newtons.csv");
    ASSERT_TRUE(equilibration::writeLoadCalibration(*found, path));
    const auto read = equilibration::readLoadCalibration(path);
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(read->loads, found->loads);
    EXPECT_EQ(read->channels, found->channels);
    EXPECT_EQ(read->gain, found->gain);
    EXPECT_EQ(read->error, found->error);
    EXPECT_EQ(read->least, found->least);
    EXPECT_EQ(read->greatest, found->greatest);
    EXPECT_EQ(read->scatter, found->scatter);
}

TEST(LoadCalibrationFile, tellsWhereItIsWrong) {
    const test::TemporaryFolder folder;
    const std::string header = "load,signal,gain,gain_se,rest,least,greatest,scatter\n";
    const auto place = [&](const std::string& rows) {
        const auto read = equilibration::readLoadCalibration(folder.write("bad.csv", header + rows));
        EXPECT_FALSE(read) << rows;
        if (read)
            return std::string();
        return std::to_string(read.error().where.line) + ':' + std::to_string(read.error().where.column);
    };
    EXPECT_EQ(place("weight_n,a,1,0,0,0,1,0\n"), "2:1");
    EXPECT_EQ(place("force_n,a,much,0,0,0,1,0\n"), "2:11");
    EXPECT_EQ(place("force_n,a,1,0,0,2,1,0\n"), "2:17");
    EXPECT_EQ(place("force_n,a,1,-2,0,0,1,0\n"), "2:13");
    EXPECT_EQ(place("force_n,a,1,0,0,0,1,-1\n"), "2:21");
    EXPECT_EQ(place("force_n,a,1,0,0,0,1,0\nforce_n,a,1,0,0,0,1,0\n"), "3:1");
    EXPECT_EQ(place("force_n,a,1,0,0,0,1,0\nshear_x_n,a,1,0,5,0,1,0\n"), "3:17");
    EXPECT_EQ(place("force_n,a,1,0,0,0,1,0\nshear_x_n,b,1,0,0,0,1,0\n"), "4:1");
    EXPECT_EQ(place("force_n,a,1,0,0,0,1,0\nforce_n,b,1,0,0,0,1,2\n"), "3:21");
    EXPECT_EQ(place(""), "2:1");
}
