// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/taxel_gain_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace teleta;
using namespace teleta::equilibration;

namespace {

constexpr core::ArrayLayout kLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};

const std::string kTable = "taxel,row,column,gain,gain_se,state\n"
                           "0,0,0,1.25,0.01,good\n"
                           "1,0,1,0.8,0.02,good\n"
                           "2,0,2,NA,NA,dead\n"
                           "3,1,0,1,0,good\n"
                           "4,1,1,NA,NA,stuck\n"
                           "5,1,2,1.1,NA,good\n";

class TaxelGainFile : public testing::Test {
protected:
    core::Expected<TaxelGains> read(const std::string& text) {
        return readTaxelGains(m_folder.write("gains.csv", text), kLayout);
    }

    /// Line and column of the error.
    void expectBad(const std::string& text, long long line, long long column) {
        const auto gains = read(text);
        ASSERT_FALSE(gains) << text;
        EXPECT_EQ(gains.error().kind, core::ErrorKind::badInput) << text;
        EXPECT_EQ(gains.error().where.line, line) << describe(gains.error());
        EXPECT_EQ(gains.error().where.column, column) << describe(gains.error());
        EXPECT_FALSE(gains.error().message.empty());
        EXPECT_FALSE(gains.error().expected.empty());
    }

    /// The table with a row in place of that one.
    [[nodiscard]] static std::string with(const std::string& before, const std::string& after) {
        std::string text = kTable;
        text.replace(text.find(before), before.size(), after);
        return text;
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(TaxelGainFile, isReadRowByRow) {
    const auto gains = read(kTable);
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_EQ(gains->layout, kLayout);
    ASSERT_EQ(gains->taxels.size(), 6U);
    EXPECT_DOUBLE_EQ(gains->taxels[0].gain, 1.25);
    EXPECT_DOUBLE_EQ(gains->taxels[0].error, 0.01);
    EXPECT_EQ(gains->taxels[2].state, TaxelState::dead);
    EXPECT_EQ(gains->taxels[4].state, TaxelState::stuck);
    EXPECT_TRUE(std::isnan(gains->taxels[4].gain));
    EXPECT_DOUBLE_EQ(gains->taxels[5].error, 0.0);
    EXPECT_EQ(gains->good(), 4U);
}

TEST_F(TaxelGainFile, needsOnlyPlaceAndGainInAnyOrder) {
    const auto gains = read("gain,note,column,row,taxel\n2,a,2,1,5\n1,,0,0,0\n1,,1,0,1\n1,,2,0,2\nNA,,0,1,3\n"
                            "1,b,1,1,4\n");
    ASSERT_TRUE(gains) << describe(gains.error());
    EXPECT_DOUBLE_EQ(gains->taxels[5].gain, 2.0);
    EXPECT_EQ(gains->taxels[3].state, TaxelState::dead);
}

TEST_F(TaxelGainFile, isReadAsItWasWritten) {
    const auto gains = read(kTable);
    ASSERT_TRUE(gains);
    const std::string path = m_folder.path("new/again.csv");
    ASSERT_TRUE(writeTaxelGains(*gains, path));
    std::string expected = kTable;
    expected.replace(expected.find("1.1,NA,good"), 11, "1.1,0,good");
    EXPECT_EQ(test::readAll(path), expected);
}

TEST_F(TaxelGainFile, badValuesAreShownWithTheirPlace) {
    expectBad(with("0,0,0,1.25", "0,0,0,fast"), 2, 7);
    expectBad(with("0,0,0,1.25", "0,0,0,-1"), 2, 7);
    expectBad(with("0,0,0,1.25", "0,0,0,0"), 2, 7);
    expectBad(with("0,0,0,1.25", "0,0,0,1e9"), 2, 7);
    expectBad(with("0,0,0,1.25", "0,0,0,inf"), 2, 7);
    expectBad(with("0,0,0,1.25", "7,0,0,1.25"), 2, 1);
    expectBad(with("0,0,0,1.25", "0,2,0,1.25"), 2, 3);
    expectBad(with("0,0,0,1.25", "0,0,3,1.25"), 2, 5);
    expectBad(with("0,0,0,1.25", "0,0,-1,1.25"), 2, 5);
    expectBad(with("0.01,good", "-1,good"), 2, 12);
    expectBad(with("0.01,good", "0.01,fine"), 2, 17);
    expectBad(with("0.01,good", "0.01,dead"), 2, 17);
    expectBad(with("NA,NA,dead", "NA,NA,good"), 4, 13);
}

TEST_F(TaxelGainFile, anotherArrayOrAnIncompleteTableIsRefused) {
    expectBad(with("1,0,1,0.8", "2,0,1,0.8"), 3, 1); // taxel 2 is not in column 1
    expectBad(with("1,0,1,0.8", "0,0,0,0.8"), 3, 1); // twice
    expectBad(kTable.substr(0, kTable.find("5,1,2")), 7, 1);
    expectBad("taxel,row,gain\n0,0,1\n", 1, 1);
    EXPECT_EQ(readTaxelGains(m_folder.path("missing.csv"), kLayout).error().kind, core::ErrorKind::notFound);
    const auto other = readTaxelGains(m_folder.write("gains.csv", kTable), {.rows = 3, .columns = 2});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().kind, core::ErrorKind::badInput);
}
