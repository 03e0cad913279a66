// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/frames/frame_reading.h"

#include <fstream>

using teleta::frames::FrameRequest;
using FrameReaderTest = teleta::test::FrameReadingTest;

TEST_F(FrameReaderTest, readsItsOwnTables) {
    FrameRequest request;
    request.rows = 1;
    request.columns = 2;
    const auto series = read("time_s,t0,t1\n0,1,2\n0.5,3,nan\n", request);
    ASSERT_TRUE(series);
    EXPECT_EQ(series->time_s, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(series->frame(0)[1], 2.0F);
}

TEST_F(FrameReaderTest, binaryFilesAreNamedAndNeverQuoted) {
    const auto named = [this](const std::string& content, const char* name) {
        const std::string why = refusal(content);
        EXPECT_NE(why.find(name), std::string::npos) << why;
    };
    named("PAR1\x15\x04", "Parquet");
    named("\x80\x04\x95 pickle", "pickle");
    named(std::string("SQLite format 3\0abc", 19), "SQLite");
    named("\x1f\x8b\x08 gzip", "gzip");
    named("\xff\xd8\xff\xe0 jpeg", "JPEG");
    named(std::string("\x00\x01\x02garbage", 10), "no known format");
    named("PK\x05\x06" + std::string(18, '\0'), "npz");
}

TEST_F(FrameReaderTest, aMissingFileIsNotFound) {
    FrameRequest request;
    request.path = m_folder.path("nowhere.npy");
    const auto series = teleta::frames::readFrames(request);
    ASSERT_FALSE(series);
    EXPECT_EQ(series.error().kind, teleta::core::ErrorKind::notFound);
}

TEST_F(FrameReaderTest, aFamilyHasTheSameColumnsOrIsOfTheSameKind) {
    const auto family = [this](const std::string& content) {
        std::ofstream(m_folder.path("file"), std::ios::binary) << content;
        return teleta::frames::familyOf(m_folder.path("file"));
    };
    const std::string named = family("stamp;a;b\n1;2;3\n");
    EXPECT_EQ(family("stamp;a;b\r\n7;8;9\n1;2;3\n"), named);
    EXPECT_NE(family("stamp;b;a\n1;2;3\n"), named);
    const std::string bare = family("1.5,2,3\n4,5,6\n");
    EXPECT_EQ(family("-7e3,8,9"), bare);
    EXPECT_NE(family("1,2\n"), bare);
    EXPECT_NE(family("PK\x03\x04 zip"), family("\x93NUMPY npy"));
    EXPECT_EQ(teleta::frames::familyOf(m_folder.path("nowhere")), "");
}

TEST_F(FrameReaderTest, columnsAreNumbersAndRanges) {
    using teleta::frames::columnRangesOf;
    const auto ranges = columnRangesOf("2..10,12");
    ASSERT_TRUE(ranges);
    ASSERT_EQ(ranges->size(), 2U);
    EXPECT_EQ((*ranges)[0].last, 10U);
    EXPECT_EQ((*ranges)[1].first, 12U);
    EXPECT_EQ(teleta::frames::textOf(*ranges), "2..10,12");
    for (const char* wrong :
         {"", "0..3", "5..3", "2..", "..3", "2...4", "a", "1,,2", "1..99999999999999999999"})
        EXPECT_FALSE(columnRangesOf(wrong)) << wrong;
}

TEST_F(FrameReaderTest, aUsualThresholdIsForNewtonsAndCounts) {
    for (const char* unit : {"N", "counts", ""})
        EXPECT_EQ(teleta::frames::usualThreshold(unit), 0.2) << unit;
    for (const char* unit : {"\u00b5T", "Pa", "mV"})
        EXPECT_FALSE(teleta::frames::usualThreshold(unit)) << unit;
}
