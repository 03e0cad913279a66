// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace teleta;
using namespace teleta::cost;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const std::string kHeader = "ladder,rung,parameter,error_mean,error_p95,error_max,error_unit,time_median_s,"
                            "time_p99_s,samples,pareto\n";

std::vector<LadderCost> someCosts() {
    return {
        {"contact-flow",
         "m",
         {{"dots", "printed dots", 0.25, 0.5, 0.001, 0.0035, 0.004, 30, 0.01, true},
          {"paper", "scale 1/3.2, \"medium\"", 0.02, 0.05, 0.06, kNan, kNan, 30, 0.9, false}}},
        {"stiffness", "1", {{"two-point-2", "2 samples", kNan, kNan, kNan, 1e-6, 2e-6, 200, 0.0, false}}}};
}

class CostFile : public testing::Test {
protected:
    std::string write(const std::string& text) { return m_folder.write("costs.csv", text); }
    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(CostFile, hasTheAgreedColumnsAndOneRowARung) {
    const std::string path = m_folder.path("tradeoff.csv");
    ASSERT_TRUE(writeCostFile(someCosts(), path));
    EXPECT_EQ(test::readAll(path),
              kHeader + "contact-flow,dots,printed dots,0.25,0.5,0.001,m,0.0035,0.004,30,yes\n"
                        "contact-flow,paper,\"scale 1/3.2, \"\"medium\"\"\",0.02,0.05,0.06,m,NA,NA,30,no\n"
                        "stiffness,two-point-2,2 samples,NA,NA,NA,1,1e-06,2e-06,200,no\n");
}

TEST_F(CostFile, isReadAsItWasWritten) {
    const std::string path = m_folder.path("tradeoff.csv");
    ASSERT_TRUE(writeCostFile(someCosts(), path));
    const auto read = readCostFile(path);
    ASSERT_TRUE(read) << core::describe(read.error());
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ((*read)[0].ladder, "contact-flow");
    EXPECT_EQ((*read)[0].errorUnit, "m");
    ASSERT_EQ((*read)[0].rungs.size(), 2U);
    const RungCost& dots = (*read)[0].rungs[0];
    EXPECT_EQ(dots.name, "dots");
    EXPECT_EQ(dots.errorP95, 0.5);
    EXPECT_EQ(dots.timeP99_s, 0.004);
    EXPECT_EQ(dots.samples, 30U);
    EXPECT_TRUE(dots.pareto);
    EXPECT_TRUE(std::isnan(dots.spread)) << "it is not in the file";
    EXPECT_EQ((*read)[0].rungs[1].parameter, "scale 1/3.2, \"medium\"");
    EXPECT_FALSE((*read)[0].rungs[1].isTimed());
    EXPECT_TRUE(std::isnan((*read)[1].rungs[0].errorMean));
}

TEST_F(CostFile, badInputIsToldWithItsPlace) {
    const auto errorOf = [&](const std::string& text) {
        const auto read = readCostFile(write(text));
        return read ? core::Error{} : read.error();
    };
    const core::Error negative = errorOf(kHeader + "a,b,c,1,1,1,m,1,1,30,yes\na,b,c,-1,1,1,m,1,1,30,yes\n");
    EXPECT_EQ(negative.kind, core::ErrorKind::badInput);
    EXPECT_EQ(negative.where.line, 3);
    EXPECT_EQ(negative.where.column, 7);
    EXPECT_EQ(errorOf(kHeader + "a,b,c,1,1,1,m,soon,1,30,yes\n").where.column, 15);
    EXPECT_EQ(errorOf(kHeader + "a,b,c,1,1,1,m,1,1,30,maybe\n").where.line, 2);
    EXPECT_EQ(errorOf(kHeader + "a,b,c,1,1,1,m,1,inf,30,no\n").where.line, 2);
    EXPECT_EQ(errorOf(kHeader + "a,b,c,1,1,1,m,1,1,1e300,no\n").where.line, 2);
    EXPECT_EQ(errorOf("ladder,rung\na,b\n").where.line, 1);
    EXPECT_EQ(errorOf("").kind, core::ErrorKind::badInput);
    EXPECT_FALSE(readCostFile(m_folder.path("missing.csv")));
}

TEST_F(CostFile, withoutRowsIsEmpty) {
    const auto read = readCostFile(write(kHeader));
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->empty());
}
