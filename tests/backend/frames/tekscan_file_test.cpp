// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/frames/frame_reading.h"

#include <cmath>

using teleta::frames::FrameRequest;

namespace {

const std::string kHead = "DATA_TYPE MOVIE\nROWS 2\nCOLS 2\nROW_SPACING 2.5 mm\nCOL_SPACING 0.25 cm\n"
                          "SECONDS_PER_FRAME 0.01\nUNITS kPa\nSENSEL_AREA 6.25 mm2\nSTART_FRAME 1\n";
const std::string kData = "ASCII_DATA @@\n";
const std::string kFirst = "\nFrame 1\n1,2\n3,B\n";

class TekscanFileTest : public teleta::test::FrameReadingTest {};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
}

} // namespace

TEST_F(TekscanFileTest, aPressureTimesTheAreaIsAForce) {
    const auto series = read(kHead + kData + kFirst + "\nFrame 2 Absolute\n0,0\n0,B\n@@\n");
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->unit, "N");
    EXPECT_EQ(series->layout.rows, 2);
    EXPECT_NEAR(series->layout.pitchX_m, 0.0025, 1e-12);
    EXPECT_FLOAT_EQ(series->values[1], 2e3F * 6.25e-6F);
    EXPECT_TRUE(std::isnan(series->values[3])) << "a place outside of the sensor";
    EXPECT_EQ(series->time_s, (std::vector<double>{0.0, 0.01}));
}

TEST_F(TekscanFileTest, countsStayCounts) {
    const auto series = read(replaced(kHead, "kPa", "RAW") + kData + kFirst);
    ASSERT_TRUE(series);
    EXPECT_EQ(series->unit, "counts");
    EXPECT_EQ(series->values[1], 2.0F);
}

TEST_F(TekscanFileTest, missingFramesLeaveAGap) {
    const auto series = read(kHead + kData + kFirst + "\nFrame 5\n0,0\n0,B\n");
    ASSERT_TRUE(series);
    EXPECT_NEAR(series->time_s[1], 0.04, 1e-12);
}

TEST_F(TekscanFileTest, readsSemicolonsWithADecimalCommaAndCarriageReturns) {
    std::string text = replaced(kHead, "0.01", "0,01") + kData + "Frame 1\n1,5;2;\n3;B;\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, "\r");
    const auto series = read(text);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_FLOAT_EQ(series->values[0], 1.5e3F * 6.25e-6F);
}

TEST_F(TekscanFileTest, aRecordingThatIsCutOffGivesNothing) {
    EXPECT_NE(refusal(kHead + kData + kFirst + "\nFrame 2\n1,2\n").find("after 1 of 2 rows"),
              std::string::npos);
    EXPECT_NE(refusal(kHead + "END_FRAME 3\n" + kData + kFirst).find("after frame 1 of 3"),
              std::string::npos);
    EXPECT_NE(refusal(kHead + kData).find("no frames"), std::string::npos);
    EXPECT_NE(refusal(kHead + kData + "Frame 1\n1,2\n3\n").find(":13:1:"), std::string::npos);
}

TEST_F(TekscanFileTest, rowsAndColumnsMayBeApartDifferently) {
    const auto series = read(replaced(kHead, "0.25 cm", "5 mm") + kData + kFirst);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_NEAR(series->layout.pitchX_m, 0.005, 1e-12);
    EXPECT_NEAR(series->layout.pitchY_m, 0.0025, 1e-12);
}

TEST_F(TekscanFileTest, rowsAndColumnsAreMirroredAsTheHeadSays) {
    const auto values = [this](const std::string& mirrors) {
        const auto series =
            read(replaced(kHead, "kPa", "RAW") + mirrors + kData + "Frame 1\n1,2\n3,4\nFrame 2\n5,6\n7,8\n");
        EXPECT_TRUE(series) << describe(series.error());
        return series ? series->values : std::vector<float>();
    };
    using Values = std::vector<float>;
    EXPECT_EQ(values("MIRROR_ROW 0\nMIRROR_COL 0\n"), (Values{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(values("MIRROR_ROW 1\n"), (Values{3, 4, 1, 2, 7, 8, 5, 6}));
    EXPECT_EQ(values("MIRROR_COL 1\n"), (Values{2, 1, 4, 3, 6, 5, 8, 7}));
    EXPECT_EQ(values("MIRROR_ROW 1\nMIRROR_COL 1\n"), (Values{4, 3, 2, 1, 8, 7, 6, 5}));
    EXPECT_NE(refusal(kHead + "MIRROR_ROW perhaps\n" + kData + kFirst).find("MIRROR_ROW"), std::string::npos);
}

TEST_F(TekscanFileTest, linesWithoutAnEffectAreNamed) {
    const auto series =
        read(kHead + "NOISE_THRESHOLD 3\nSCALE_FACTOR 2\nSENSITIVITY S-30\n" + kData + kFirst);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->unused, (std::vector<std::string>{"NOISE_THRESHOLD", "SCALE_FACTOR", "SENSITIVITY"}));
    EXPECT_FLOAT_EQ(series->values[1], 2e3F * 6.25e-6F);
    EXPECT_TRUE(read(kHead + kData + kFirst)->unused.empty());
}

TEST_F(TekscanFileTest, headsThatDoNotFitAreRefused) {
    EXPECT_NE(refusal(replaced(kHead, "COLS 2", "COLS 2000") + kData + kFirst).find("COLS"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(kHead, "kPa", "furlongs") + kData + kFirst).find("UNITS"), std::string::npos);
    EXPECT_NE(refusal(replaced(kHead, "SECONDS_PER_FRAME 0.01\n", "") + kData + kFirst).find("--rate"),
              std::string::npos);
    FrameRequest request;
    request.rows = 3;
    EXPECT_NE(refusal(kHead + kData + kFirst, request).find("ROWS"), std::string::npos);
}
