// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr const char* kColumns =
    "time_s,contact_type,force_n,cop_x_m,cop_y_m,coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,"
    "alpha_z_rad,lambda1_m2,lambda2_m2,active";
enum Column {
    kTime,
    kType,
    kForce,
    kCopX,
    kCopY,
    kCocX,
    kCocY,
    kDzmpX,
    kDzmpY,
    kAlpha,
    kLambda1,
    kLambda2,
    kActive
};

/// Frames of a 2 x 3 array with a pitch of 10 mm: x is -0.01, 0, 0.01 and y is -0.005, 0.005.
class FeaturesCommand : public testing::Test {
protected:
    std::vector<std::vector<std::string>> rows(const std::string& frames,
                                               std::vector<std::string> options = {}) {
        const std::string path = m_folder.write("frames.csv", "time_s,t0,t1,t2,t3,t4,t5\n" + frames);
        options.insert(options.begin(),
                       {"features", path, "--rows", "2", "--columns", "3", "--pitch-mm", "10"});
        const ProgramResult result = run(options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(result.out.substr(0, result.out.find('\n')), kColumns);
        std::vector<std::vector<std::string>> all = splitCsv(result.out);
        if (!all.empty())
            all.erase(all.begin());
        return all;
    }

    TemporaryFolder m_folder;
};

constexpr double kTolerance = 1e-9; // loads are single precision, the ones here are exact

} // namespace

TEST_F(FeaturesCommand, ofTwoTaxelsAreThoseComputedByHand) {
    // 1 N at (-0.01, -0.005) and 3 N at (0.01, -0.005): CoP x = (3 - 1) 0.01/4; the binary image is
    // symmetric. Covariance of x with n - 1 = 1 in the denominator: 2 (0.01)^2.
    const auto row = rows("0.125,1,0,3,0,0,0\n").at(0);
    ASSERT_EQ(row.size(), 13U);
    EXPECT_EQ(row[kTime], "0.125");
    EXPECT_EQ(row[kType], "edge");
    EXPECT_EQ(row[kForce], "4");
    EXPECT_NEAR(std::stod(row[kCopX]), 0.005, kTolerance);
    EXPECT_NEAR(std::stod(row[kCopY]), -0.005, kTolerance);
    EXPECT_NEAR(std::stod(row[kCocX]), 0.0, kTolerance);
    EXPECT_NEAR(std::stod(row[kCocY]), -0.005, kTolerance);
    EXPECT_NEAR(std::stod(row[kDzmpX]), 0.0, kTolerance);
    EXPECT_NEAR(std::stod(row[kDzmpY]), 0.005, kTolerance);
    EXPECT_NEAR(std::stod(row[kAlpha]), 0.0, kTolerance);
    EXPECT_NEAR(std::stod(row[kLambda1]), 2e-4, kTolerance);
    EXPECT_NEAR(std::stod(row[kLambda2]), 0.0, kTolerance);
    EXPECT_EQ(row[kActive], "2");
}

TEST_F(FeaturesCommand, ofADiagonalHaveItsAngle) {
    // (0, -0.005) to (0.01, 0.005): 45 degrees.
    const auto row = rows("0,0,1,0,0,0,1\n").at(0);
    EXPECT_NEAR(std::stod(row[kAlpha]), std::numbers::pi / 4.0, kTolerance);
    EXPECT_NEAR(std::stod(row[kLambda1]), 1e-4, kTolerance);
}

TEST_F(FeaturesCommand, whatIsUndefinedIsNA) {
    const auto all = rows("0,0,0,0,0,0,0\n1,0,0,0,0,2,0\n");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0], (std::vector<std::string>{"0", "none", "0", "NA", "NA", "NA", "NA", "NA", "NA", "NA",
                                                "NA", "NA", "0"}));
    EXPECT_EQ(all[1][kType], "point");
    EXPECT_EQ(all[1][kForce], "2");
    EXPECT_NEAR(std::stod(all[1][kCopY]), 0.005, kTolerance);
    EXPECT_EQ(all[1][kAlpha], "NA");
    EXPECT_EQ(all[1][kLambda1], "NA");
    EXPECT_EQ(all[1][kLambda2], "NA");
    EXPECT_EQ(all[1][kActive], "1");
}

TEST_F(FeaturesCommand, taxelsThatAreNotFiniteAreDead) {
    const auto all = rows("0,1,nan,3,0,0,0\n1,1,inf,3,NA,-inf,0\n");
    for (const auto& row : all) {
        EXPECT_EQ(row[kForce], "4");
        EXPECT_NEAR(std::stod(row[kCopX]), 0.005, kTolerance);
    }
}

TEST_F(FeaturesCommand, tareGainAndInversionMakeTheLoad) {
    // Tare 100 (mean of 99 and 101), load = -0.5 (raw - 100): 98 is 1 N, 94 is 3 N, 104 carries nothing.
    const std::string tare = m_folder.write("tare.csv", "time_s,t0,t1,t2,t3,t4,t5\n0,99,99,99,99,99,99\n"
                                                        "1,101,101,101,101,101,101\n");
    const auto row = rows("0,98,100,94,104,100,100\n", {"--tare", tare, "--invert", "--gain", "0.5"}).at(0);
    EXPECT_EQ(row[kForce], "4");
    EXPECT_NEAR(std::stod(row[kCopX]), 0.005, kTolerance);
    EXPECT_EQ(row[kActive], "2");
}

TEST_F(FeaturesCommand, aTaxelWhoseTareIsNeverFiniteIsDead) {
    const std::string tare =
        m_folder.write("tare.csv", "time_s,t0,t1,t2,t3,t4,t5\n0,0,nan,0,0,0,0\n1,0,NA,0,0,0,0\n");
    EXPECT_EQ(rows("0,1,50,3,0,0,0\n", {"--tare", tare}).at(0)[kForce], "4");
}

TEST_F(FeaturesCommand, namedDeadTaxelsAreLeftOut) {
    EXPECT_EQ(rows("0,1,7,3,0,9,0\n", {"--dead", "1,4"}).at(0)[kForce], "4");
    EXPECT_EQ(rows("0,1,7,3,0,9,0\n", {"--dead", "1", "--dead", "4"}).at(0)[kForce], "4");
}

TEST_F(FeaturesCommand, thresholdDecidesWhatIsActiveButNotTheForceOfTheImage) {
    const std::string frame = "0,1,0.125,3,0.125,0,0\n";
    EXPECT_EQ(rows(frame).at(0)[kActive], "2");
    EXPECT_EQ(rows(frame).at(0)[kForce], "4.25");
    EXPECT_EQ(rows(frame, {"--threshold", "0.125"}).at(0)[kActive], "4");
    EXPECT_EQ(rows(frame, {"--threshold", "2"}).at(0)[kActive], "1");
    EXPECT_EQ(rows(frame, {"--active-only"}).at(0)[kForce], "4");
    EXPECT_NEAR(std::stod(rows(frame, {"--active-only"}).at(0)[kCopX]), 0.005, kTolerance);
}

TEST_F(FeaturesCommand, orientationMayBeWeightedWithTheLoad) {
    // Four corners, three along an ascending diagonal carry much more: their weight turns the axis upwards.
    // Without weights the picture is symmetric and the axis lies along x, where the array is wider.
    const std::string frame = "0,8,0,0.25,0.25,0,8\n";
    EXPECT_NEAR(std::stod(rows(frame).at(0)[kAlpha]), 0.0, kTolerance);
    EXPECT_GT(std::stod(rows(frame, {"--weighted"}).at(0)[kAlpha]), 0.1);
}

TEST_F(FeaturesCommand, automaticThresholdIsNeverBelowTheGivenOne) {
    const std::string frames = "0,1,0.3,3,0.3,0.25,0\n1,0.1,0.1,0.1,0.1,0.1,0.1\n2,0,0,0,0,0,0\n";
    const auto fixed = rows(frames);
    const auto automatic = rows(frames, {"--auto-threshold"});
    ASSERT_EQ(automatic.size(), 3U);
    for (std::size_t i = 0; i < automatic.size(); ++i)
        EXPECT_LE(std::stoi(automatic[i][kActive]), std::stoi(fixed[i][kActive]));
    EXPECT_EQ(automatic[1][kType], "none");
}

TEST_F(FeaturesCommand, timesAndNumbersKeepAllTheirDigits) {
    const auto row = rows("1234567.0000001,1e-3,0,3e8,0,0,0\n").at(0);
    EXPECT_EQ(row[kTime], "1234567.0000001");
    const double force = std::stod(row[kForce]);
    EXPECT_EQ(force, static_cast<double>(1e-3F) + 3e8);
}

namespace {

/// A strip of seven taxels with a pitch of 10 mm.
std::vector<std::vector<std::string>> stripRows(const std::string& command, const std::string& frames,
                                                std::vector<std::string> options) {
    const TemporaryFolder folder;
    const std::string path = folder.write("frames.csv", "time_s,t0,t1,t2,t3,t4,t5,t6\n" + frames);
    options.insert(options.begin(), {command, path, "--rows", "1", "--columns", "7", "--pitch-mm", "10"});
    const ProgramResult result = run(options);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return splitCsv(result.out);
}

} // namespace

TEST_F(FeaturesCommand, summitOfAStripStandsBehindTheOtherColumns) {
    // An even pressure of 4 N a taxel from 1.75 to 4.25 taxels; the next frame covers the end of the strip.
    const std::string frames = "0,0,0,3,4,3,0,0\n1,4,1,0,0,0,0,0\n2,0,0,0,0,0,0,0\n3,0,0,2,4,4,1,0\n";
    for (const std::string command : {"features", "contacts"}) {
        const auto plain = stripRows(command, frames, {});
        const auto all = stripRows(command, frames, {"--summit", "--noise-sd", "0.01"});
        ASSERT_EQ(all.size(), plain.size());
        const std::size_t columns = plain[0].size();
        for (std::size_t row = 0; row < all.size(); ++row) {
            ASSERT_EQ(all[row].size(), columns + 4);
            EXPECT_TRUE(std::equal(plain[row].begin(), plain[row].end(), all[row].begin()));
        }
        const std::vector<std::string> names(all[0].begin() + static_cast<std::ptrdiff_t>(columns),
                                             all[0].end());
        EXPECT_EQ(names,
                  (std::vector<std::string>{"summit_x_m", "summit_y_m", "summit_x_se_m", "summit_y_se_m"}));
        EXPECT_NEAR(std::stod(all[1][columns]), 0.0, kTolerance);
        EXPECT_EQ(all[1][columns + 1], "0");
        EXPECT_NEAR(std::stod(all[1][columns + 2]), 0.01 * std::hypot(0.05, 0.5 * 0.0025 * std::sqrt(2.0)),
                    kTolerance);
        EXPECT_EQ(all[1][columns + 3], "NA");
        EXPECT_EQ(all[2][columns], "NA") << command;
        // From 2 - 1/2 + 1/2 to 5 - 1/2 + 1/4.
        EXPECT_NEAR(std::stod(all.back()[columns]), 0.01 * (0.5 * (2.0 + 4.75) - 3.0), kTolerance);

        EXPECT_EQ(stripRows(command, frames, {"--summit"})[1][columns + 2], "NA") << "the noise is not told";
    }
}

TEST_F(FeaturesCommand, untouchedValuesAreFoundInTheRecording) {
    // A touch goes to and fro over a strip that reads 500 without load and falls under it.
    std::string frames;
    for (int i = 0; i < 400; ++i) {
        frames += std::to_string(i);
        for (int taxel = 0; taxel < 7; ++taxel) {
            const double place = 1.0 + 4.0 * std::abs(i % 40 - 20) / 20.0;
            const double load = 300.0 * std::max(0.0, 1.0 - std::abs(taxel - place) / 1.5);
            frames += "," + std::to_string(500 - static_cast<int>(load) + (i * 7 + taxel) % 3 - 1);
        }
        frames += "\n";
    }
    const auto all = stripRows("contacts", frames, {"--tare", "untouched", "--invert", "--threshold", "20"});
    ASSERT_EQ(all.size(), 401U) << "one contact a frame";
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_LE(std::stod(all[i][5]), 302.0) << "the peak";

    const std::string path = m_folder.write("held.csv", "time_s,t0\n0,1\n1,2\n2,3\n");
    const ProgramResult refused =
        run({"features", path, "--rows", "1", "--columns", "1", "--tare", "untouched"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.err.find("taxel 0"), std::string::npos) << refused.err;
}
