// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <cmath>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr double kTolerance = 1e-9;
enum Column { kTime, kId, kX, kY, kForce, kPeak, kArea };

/// Frames of a 3 x 7 array with a pitch of 2 mm: x is -6, -4 ... 6 mm, y is -2, 0, 2 mm.
class ContactsCommand : public testing::Test {
protected:
    std::vector<std::vector<std::string>> rows(const std::string& frames,
                                               std::vector<std::string> options = {}) {
        std::string header = "time_s";
        for (int i = 0; i < 21; ++i)
            header += ",t" + std::to_string(i);
        const std::string path = m_folder.write("frames.csv", header + '\n' + frames);
        options.insert(options.begin(),
                       {"contacts", path, "--rows", "3", "--columns", "7", "--pitch-mm", "2"});
        const ProgramResult result = run(options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.out.substr(0, result.out.find('\n')),
                  "time_s,contact_id,x_m,y_m,force_n,peak_n,area_m2");
        std::vector<std::vector<std::string>> all = splitCsv(result.out);
        if (!all.empty())
            all.erase(all.begin());
        return all;
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(ContactsCommand, twoBlobsAreTwoContactsWithTheirCentroids) {
    // Left: 2 N at (-6, 0) mm and 1 N at (-4, 0) mm. Right: 1 N at (6, 2) mm.
    const auto all = rows("0.5,0,0,0,0,0,0,0,2,1,0,0,0,0,0,0,0,0,0,0,0,1\n");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0][kTime], "0.5");
    EXPECT_NEAR(std::stod(all[0][kX]), (2.0 * -0.006 + 1.0 * -0.004) / 3.0, kTolerance);
    EXPECT_NEAR(std::stod(all[0][kY]), 0.0, kTolerance);
    EXPECT_EQ(all[0][kForce], "3");
    EXPECT_EQ(all[0][kPeak], "2");
    EXPECT_NEAR(std::stod(all[0][kArea]), 2 * 4e-6, 1e-15);
    EXPECT_NEAR(std::stod(all[1][kX]), 0.006, kTolerance);
    EXPECT_NEAR(std::stod(all[1][kY]), 0.002, kTolerance);
    EXPECT_EQ(all[1][kForce], "1");
    EXPECT_NE(all[0][kId], all[1][kId]);
}

TEST_F(ContactsCommand, identitiesStayWhenTheOrderOfTheForcesChanges) {
    const auto all = rows("0,0,0,0,0,0,0,0,3,0,0,0,0,0,1,0,0,0,0,0,0,0\n"
                          "0.01,0,0,0,0,0,0,0,1,0,0,0,0,0,3,0,0,0,0,0,0,0\n");
    ASSERT_EQ(all.size(), 4U);
    std::string idOf[2][2]; // [frame][0 left, 1 right]
    for (const auto& row : all)
        idOf[row[kTime] == "0" ? 0 : 1][std::stod(row[kX]) > 0.0 ? 1 : 0] = row[kId];
    EXPECT_NE(idOf[0][0], idOf[0][1]);
    EXPECT_EQ(idOf[0][0], idOf[1][0]);
    EXPECT_EQ(idOf[0][1], idOf[1][1]);
}

TEST_F(ContactsCommand, identitiesStayHoweverSlowTheFramesCome) {
    std::string frames;
    for (const char* time : {"0", "0.1", "0.2", "0.3", "0.4", "5", "60"})
        frames += std::string(time) + ",0,0,0,0,0,0,0,3,0,0,0,0,0,0,0,0,0,0,0,0,0\n";
    const auto all = rows(frames);
    ASSERT_EQ(all.size(), 7U);
    for (const auto& row : all)
        EXPECT_EQ(row[kId], "1") << "at " << row[kTime] << " s";
}

TEST_F(ContactsCommand, framesWithoutContactHaveNoRow) {
    EXPECT_TRUE(rows("0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"
                     "1,0,0,0,0,0,0,0,0.1,0,0,0,0,0,0,0,0,0,0,0,0,0\n")
                    .empty());
}

TEST_F(ContactsCommand, noiseHeightMergesAndSeparatesSummits) {
    // Two summits of 4 N and 3 N with a saddle of 2 N: the lower one rises 1 N, which is 25 % of the peak.
    const std::string frame = "0,0,0,0,0,0,0,0,4,2,3,0,0,0,0,0,0,0,0,0,0,0\n";
    EXPECT_EQ(rows(frame, {"--noise-height", "0.2"}).size(), 2U);
    EXPECT_EQ(rows(frame, {"--noise-height", "0.3"}).size(), 1U);
}

TEST_F(ContactsCommand, smallContactsCanBeDropped) {
    const std::string frame = "0,0,0,0,0,0,0,0,2,1,0,0,0,0,0,0,0,0,0,0,0,1\n";
    const auto all = rows(frame, {"--min-taxels", "2"});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0][kForce], "3");
}

TEST_F(ContactsCommand, deadTaxelsBelongToNoContact) {
    const auto all = rows("0,0,0,0,0,0,0,0,2,nan,0,0,0,0,0,0,0,0,0,0,0,1\n", {"--dead", "20"});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0][kForce], "2");
}

TEST_F(ContactsCommand, automaticThresholdIsNeverBelowTheGivenOne) {
    const std::string frames = "0,0,0,0,0,0,0,0,2,1,0.3,0,0,0,0,0,0,0,0,0,0,1\n";
    double fixed_N = 0.0;
    double automatic_N = 0.0;
    for (const auto& row : rows(frames))
        fixed_N += std::stod(row[kForce]);
    for (const auto& row : rows(frames, {"--auto-threshold"}))
        automatic_N += std::stod(row[kForce]);
    EXPECT_GT(automatic_N, 0.0);
    EXPECT_LE(automatic_N, fixed_N);
}
