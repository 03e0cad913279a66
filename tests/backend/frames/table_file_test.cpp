// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/table_file.h"
#include "tests/backend/frames/frame_reading.h"

using teleta::frames::FrameRequest;
using TableFileTest = teleta::test::FrameReadingTest;

namespace {

FrameRequest twoTaxels(std::size_t first, const char* timeColumn = "1") {
    FrameRequest request;
    request.rows = 1;
    request.taxelColumns = {{first, first + 1}};
    request.timeColumn = timeColumn;
    return request;
}

} // namespace

TEST_F(TableFileTest, readsColumnsByNumberAndName) {
    FrameRequest request = twoTaxels(2, "t");
    request.timeUnit = "ms";
    const auto series = read("t,s1,s2,note\n0,1,2,9\n250,3,4,9\n", request);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->time_s, (std::vector<double>{0.0, 0.25}));
    EXPECT_EQ(series->values, (std::vector<float>{1, 2, 3, 4}));
    EXPECT_EQ(series->layout.columns, 2);
}

TEST_F(TableFileTest, readsADecimalCommaBetweenSemicolons) {
    const auto series = read("\xEF\xBB\xBFtime_s;a;b\r\n0,5;1,25;-2,5e1\r\n1;+3;NA\r\n", twoTaxels(2));
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->time_s, (std::vector<double>{0.5, 1.0}));
    EXPECT_EQ(series->values[0], 1.25F);
    EXPECT_EQ(series->values[1], -25.0F);
}

TEST_F(TableFileTest, readsATableWithoutAHeaderAndWithTabs) {
    const auto series = read("# made by hand\n0\t1\t2\n1\t3\t4\n", twoTaxels(2));
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->frames(), 2U);
}

TEST_F(TableFileTest, theNameOfTheTimesSaysTheirUnit) {
    for (const char* name : {"timestamp_ms", "time [ms]", "t(ms)"}) {
        const auto series = read(std::string(name) + ",s1,s2\n0,1,2\n500,3,4\n", twoTaxels(2));
        ASSERT_TRUE(series) << describe(series.error());
        EXPECT_EQ(series->time_s[1], 0.5) << name;
    }
}

TEST_F(TableFileTest, readsDatesOfIso8601) {
    const auto series =
        read("when,a,b\n2026-05-01T12:00:00.250001Z,1,2\n2026-05-01T14:00:01.25+02:00,3,4\n", twoTaxels(2));
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->time_s[0], 0.0);
    EXPECT_NEAR(series->time_s[1], 0.999999, 1e-6);
}

TEST_F(TableFileTest, aRateStandsForTimes) {
    FrameRequest request;
    request.rows = 1;
    request.columns = 2;
    request.rate_Hz = 4.0;
    const auto series = read("1;2\n3;4\n", request);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->time_s, (std::vector<double>{0.0, 0.25}));
    request.rate_Hz.reset();
    request.taxelColumns = {{1, 2}};
    EXPECT_NE(refusal("1;2\n3;4\n", request).find("--time-column"), std::string::npos);
}

TEST_F(TableFileTest, wrongRowsAreFoundWithTheirPlace) {
    const auto why = [this](const std::string& rows) { return refusal("t,a,b\n" + rows, twoTaxels(2)); };
    EXPECT_NE(why("0,1,2\n1,x,4\n").find(":3:3:"), std::string::npos);
    EXPECT_NE(why("0,1,2\n1,3\n").find(":3:1:"), std::string::npos);
    EXPECT_NE(why("1,1,2\n0,3,4\n").find("goes back"), std::string::npos);
    EXPECT_NE(why("nan,1,2\n").find("not a time"), std::string::npos);
    EXPECT_NE(why("").find("no frames"), std::string::npos);
    EXPECT_NE(refusal("t,a\n0,1\n", twoTaxels(2)).find("2 columns"), std::string::npos);
    EXPECT_NE(refusal("t,a,b\n0,1,2\n", twoTaxels(2, "u")).find("no column"), std::string::npos);
    EXPECT_NE(refusal("t,a,b\n0,1,2\n", twoTaxels(1)).find("either"), std::string::npos);
}

TEST_F(TableFileTest, aForeignTableIsRefusedWithTheOptionsThatReadIt) {
    EXPECT_NE(refusal("timestamp_ms,s1,s2\n0,1,2\n")
                  .find("--columns 2..3 --time-column timestamp_ms --time-unit ms"),
              std::string::npos);
    EXPECT_NE(refusal("s1;s2;when\n1,5;2;2026-05-01T12:00:00\n")
                  .find("--columns 1..2 --time-column when --time-unit iso"),
              std::string::npos);
    // The times stand between the taxels: they belong to no range.
    const std::string between = "s1,timestamp_ms,s2,s3\n1,0,2,3\n4,500,5,6\n";
    EXPECT_NE(refusal(between).find("--columns 1..1,3..4 --time-column timestamp_ms --time-unit ms"),
              std::string::npos);
    FrameRequest request;
    request.rows = 1;
    request.taxelColumns = {{1, 1}, {3, 4}};
    request.timeColumn = "timestamp_ms";
    const auto series = read(between, request);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->time_s[1], 0.5);
    EXPECT_EQ(series->values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_NE(refusal("1 2 3\n4 5 6\n").find("--columns 1..3 --rate HZ"), std::string::npos);
    EXPECT_EQ(refusal("{\"frames\": [1, 2]}\n").find("--columns"), std::string::npos);
}
