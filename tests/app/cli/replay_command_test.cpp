// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class ReplayCommand : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(
            run({"simulate", "tactile-indenter", "--duration", "3", "--out", m_folder.path("run")}).exitCode,
            0);
    }
    [[nodiscard]] std::string recording() const { return m_folder.path("run/recording.teleta"); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(ReplayCommand, theFeaturesAreThoseOfTheFramesThatWereRecorded) {
    const ProgramResult replayed = run({"replay", recording(), "--threshold", "0.1"});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    const ProgramResult computed = run({"features", m_folder.path("run/frames.csv"), "--threshold", "0.1"});
    ASSERT_EQ(computed.exitCode, 0) << computed.err;
    const auto rows = splitCsv(replayed.out);
    const auto expected = splitCsv(computed.out);
    ASSERT_EQ(rows.size(), expected.size());
    ASSERT_GT(rows.size(), 300U);
    EXPECT_EQ(rows[0], expected[0]);
    std::size_t touching = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_NEAR(std::stod(rows[i][0]), std::stod(expected[i][0]), 1e-9);
        ASSERT_TRUE(std::equal(rows[i].begin() + 1, rows[i].end(), expected[i].begin() + 1)) << "row " << i;
        touching += rows[i][1] != "none" ? 1 : 0;
    }
    EXPECT_GT(touching, 10U);
}

TEST_F(ReplayCommand, aSpeedPacesIt) {
    // A paced source drops what its reader is late for, as a device does.
    const ProgramResult replayed =
        run({"replay", recording(), "--speed", "50", "--out", m_folder.path("f.csv")});
    ASSERT_EQ(replayed.exitCode, 0) << replayed.err;
    const auto rows = splitCsv(readAll(m_folder.path("f.csv")));
    EXPECT_GT(rows.size(), 100U);
}

TEST_F(ReplayCommand, aStreamIsChosenByItsName) {
    EXPECT_EQ(run({"replay", recording(), "--stream", "frames", "--out", m_folder.path("f.csv")}).exitCode,
              0);
    const ProgramResult unknown = run({"replay", recording(), "--stream", "skin"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("frames"), std::string::npos) << unknown.err;
}

TEST_F(ReplayCommand, whatIsNoRecordingIsABadInput) {
    EXPECT_EQ(run({"replay", m_folder.path("run/frames.csv")}).exitCode, 3);
    EXPECT_EQ(run({"replay", m_folder.path("none.teleta")}).exitCode, 3);
    EXPECT_EQ(run({"replay", recording(), "--speed", "0"}).exitCode, 2);
}
