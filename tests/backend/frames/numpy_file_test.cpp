// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"
#include "backend/frames/npz_writer.h"
#include "tests/backend/frames/frame_reading.h"

#include <algorithm>
#include <array>
#include <cmath>

using teleta::frames::FrameAxis;
using teleta::frames::FrameRequest;
using teleta::frames::NpzArray;
using teleta::frames::writeNpz;
using teleta::test::FrameReadingTest;

namespace {

/// An npy file byte by byte, as NumPy's page on the format describes it; version: 1, 2 or 3.
std::string npy(const std::string& literal, const std::string& values, int version = 1) {
    std::string text = literal + "\n";
    std::string file = "\x93NUMPY";
    file += static_cast<char>(version);
    file += '\0';
    file += static_cast<char>(text.size() & 0xffU);
    file += static_cast<char>(text.size() >> 8U);
    if (version > 1)
        file += std::string(2, '\0');
    return file + text + values;
}

std::string head(const std::string& descr, const std::string& shape, const char* fortran = "False") {
    return "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': (" + shape + "), }";
}

FrameRequest atOneHertz() {
    FrameRequest request;
    request.rate_Hz = 1.0;
    return request;
}

class NumpyFileTest : public FrameReadingTest {
protected:
    std::vector<float> values(const std::string& content) {
        const auto series = read(content, atOneHertz());
        EXPECT_TRUE(series) << describe(series.error());
        return series ? series->values : std::vector<float>();
    }
};

} // namespace

TEST_F(NumpyFileTest, readsEachVersionOfTheFormat) {
    const std::string bytes("\x01\x02\x03\x04", 4);
    for (const int version : {1, 2, 3})
        EXPECT_EQ(values(npy(head("|u1", "2, 1, 2"), bytes, version)), (std::vector<float>{1, 2, 3, 4}));
}

TEST_F(NumpyFileTest, readsNumbersOfEitherByteOrder) {
    EXPECT_EQ(values(npy(head("<i2", "1, 1, 2"), std::string("\xff\xff\x00\x80", 4))),
              (std::vector<float>{-1, -32768}));
    EXPECT_EQ(values(npy(head(">u2", "1, 1, 2"), std::string("\x01\x00\x00\xff", 4))),
              (std::vector<float>{256, 255}));
    EXPECT_EQ(values(npy(head(">f4", "1, 1, 1"), std::string("\x3f\xc0\x00\x00", 4))),
              (std::vector<float>{1.5F}));
    // Halves: 1, -2, the smallest subnormal 2^-24, infinity.
    const auto halves =
        values(npy(head("<f2", "1, 1, 4"), std::string("\x00\x3c\x00\xc0\x01\x00\x00\x7c", 8)));
    ASSERT_EQ(halves.size(), 4U);
    EXPECT_EQ(halves[0], 1.0F);
    EXPECT_EQ(halves[1], -2.0F);
    EXPECT_EQ(halves[2], std::ldexp(1.0F, -24));
    EXPECT_TRUE(std::isinf(halves[3]));
}

TEST_F(NumpyFileTest, turnsFortranOrder) {
    // Frame 0 is [[0, 1], [2, 3]], frame 1 is [[4, 5], [6, 7]]; the first index is the quickest one.
    const std::string turned("\x00\x04\x02\x06\x01\x05\x03\x07", 8);
    EXPECT_EQ(values(npy(head("|u1", "2, 2, 2", "True"), turned)),
              (std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST_F(NumpyFileTest, takesTheFramesFromTheLastDimensionWhenAsked) {
    FrameRequest request = atOneHertz();
    request.axis = FrameAxis::last;
    request.rows = 1; // three columns could be a vector
    const auto series =
        read(npy(head("|u1", "1, 3, 2"), std::string("\x00\x01\x02\x03\x04\x05", 6)), request);
    ASSERT_TRUE(series);
    EXPECT_EQ(series->frames(), 2U);
    EXPECT_EQ(series->values, (std::vector<float>{0, 2, 4, 1, 3, 5}));
}

TEST_F(NumpyFileTest, twoDimensionsNeedRowsAndColumns) {
    const std::string content = npy(head("|u1", "1, 6"), std::string(6, '\x01'));
    EXPECT_NE(refusal(content, atOneHertz()).find("--rows"), std::string::npos);
    FrameRequest request = atOneHertz();
    request.rows = 2;
    request.columns = 3;
    const auto series = read(content, request);
    ASSERT_TRUE(series);
    EXPECT_EQ(series->layout.columns, 3);
}

TEST_F(NumpyFileTest, threeValuesBesideEachOtherMayBeAVector) {
    const std::string content = npy(head("|u1", "1, 2, 3"), std::string("\x01\x02\x03\x04\x05\x06"));
    const std::string why = refusal(content, atOneHertz());
    EXPECT_NE(why.find("2 taxels with x, y and z"), std::string::npos) << why;
    EXPECT_NE(why.find("--rows 2 --columns 3"), std::string::npos) << why;
    EXPECT_NE(why.find("--layout"), std::string::npos) << why;
    FrameRequest request = atOneHertz();
    request.rows = 2;
    const auto grid = read(content, request);
    ASSERT_TRUE(grid) << describe(grid.error());
    EXPECT_EQ(grid->layout.columns, 3);

    FrameRequest vectors = atOneHertz();
    vectors.known = {.layout = teleta::core::TaxelLayout({1, 2}, 3), .numbers = 6, .place{}, .unit = "N"};
    vectors.known->place = [](std::span<const float> numbers, std::span<float> frame) {
        std::ranges::reverse_copy(numbers, frame.begin());
    };
    const auto series = read(content, vectors);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->values, (std::vector<float>{6, 5, 4, 3, 2, 1})) << "as the layout places them";
    EXPECT_EQ(series->unit, "N");
    vectors.known->numbers = 9;
    vectors.known->layout = teleta::core::TaxelLayout({1, 3}, 3);
    EXPECT_NE(refusal(content, vectors).find("3 taxels x 3"), std::string::npos);
}

TEST_F(NumpyFileTest, framesWithoutTimesNeedARate) {
    EXPECT_NE(refusal(npy(head("|u1", "1, 1, 1"), "\x01")).find("--rate"), std::string::npos);
}

TEST_F(NumpyFileTest, refusesWhatIsNoNumberAndSaysWhatItIs) {
    const auto why = [this](const std::string& literal) {
        return refusal(npy(literal, "12345678"), atOneHertz());
    };
    EXPECT_NE(why(head("|O", "1, 1, 1")).find("pickled"), std::string::npos);
    EXPECT_NE(why(head("<c8", "1, 1, 1")).find("complex"), std::string::npos);
    EXPECT_NE(why(head("<U2", "1, 1, 1")).find("texts"), std::string::npos);
    EXPECT_NE(why(head("<f16", "1, 1, 1")).find("<f16"), std::string::npos);
    EXPECT_NE(why("{'descr': [('a', '<f4'), ('b', '<f4')], 'fortran_order': False, 'shape': (1, 1, 1), }")
                  .find("structured"),
              std::string::npos);
}

TEST_F(NumpyFileTest, damagedHeadsAreFoundWithTheByte) {
    EXPECT_NE(refusal(npy("{'descr': '<f4', 'fortran_order': Perhaps, 'shape': (1,), }", "")).find("byte 44"),
              std::string::npos);
    EXPECT_NE(refusal(npy("{'descr': '<f4', 'shape': (1,), }", "")).find("fortran_order"), std::string::npos);
    EXPECT_NE(refusal(npy(head("<f4", "-1,"), "")).find("byte"), std::string::npos);
    EXPECT_NE(refusal("\x93NUMPY\x01").find("head"), std::string::npos);
    EXPECT_NE(refusal(npy(head("<f4", "1,"), "", 4)).find("version 4.0"), std::string::npos);
}

TEST_F(NumpyFileTest, aFileThatIsCutOffGivesNothing) {
    const std::string why = refusal(npy(head("<f4", "2, 1, 2"), std::string(15, 'x')), atOneHertz());
    EXPECT_NE(why.find("after 3 of 4 values"), std::string::npos) << why;
    EXPECT_NE(refusal(npy(head("|u1", "1, 1, 1"), "12"), atOneHertz()).find("goes on"), std::string::npos);
}

TEST_F(NumpyFileTest, hugeShapesTakeNoMemory) {
    EXPECT_NE(refusal(npy(head("<f4", "2147483649, 1, 1"), ""), atOneHertz()).find("too large"),
              std::string::npos);
    EXPECT_NE(
        refusal(npy(head("<f8", "18446744073709551615, 1024, 1024"), ""), atOneHertz()).find("too large"),
        std::string::npos);
    EXPECT_NE(refusal(npy(head("<f8", "2000, 1024, 1024"), ""), atOneHertz()).find("after 0 of"),
              std::string::npos);
    EXPECT_NE(refusal(npy(head("<f8", "1, 1, 1025"), ""), atOneHertz()).find("1024"), std::string::npos);
    EXPECT_NE(refusal(npy(head("<f8", "0, 2, 2"), ""), atOneHertz()).find("no frames"), std::string::npos);
}

TEST_F(NumpyFileTest, whatIsWrittenAsNpzReadsBack) {
    const std::string path = m_folder.path("out.npz");
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    const std::vector<double> time_s{0.25, 0.5};
    const std::array arrays{NpzArray("frames", {2, 3, 1}, std::span(values)),
                            NpzArray("time_s", {2}, std::span(time_s))};
    ASSERT_TRUE(writeNpz(path, arrays));
    FrameRequest request;
    request.path = path;
    const auto series = teleta::frames::readFrames(request);
    ASSERT_TRUE(series) << describe(series.error());
    EXPECT_EQ(series->values, values);
    EXPECT_EQ(series->time_s, time_s);
    request.rate_Hz = 5.0;
    EXPECT_FALSE(teleta::frames::readFrames(request)) << "the file has times";
}

TEST_F(NumpyFileTest, everyCutOfAnNpzIsRefused) {
    const std::string path = m_folder.path("out.npz");
    const std::vector<float> values(60, 1.0F);
    const std::array arrays{NpzArray("frames", {10, 3, 2}, std::span(values))};
    ASSERT_TRUE(writeNpz(path, arrays));
    const std::string whole = teleta::core::readFile(path).value();
    ASSERT_EQ(refusal(whole, atOneHertz()), "");
    for (std::size_t length = 4; length < whole.size(); ++length)
        EXPECT_NE(refusal(whole.substr(0, length), atOneHertz()), "") << length;
    std::string changed = whole;
    changed[whole.find("NUMPY") + 200] ^= 1; // a value
    EXPECT_NE(refusal(changed, atOneHertz()).find("damaged"), std::string::npos);
}

TEST_F(NumpyFileTest, severalArraysAreListed) {
    const std::string path = m_folder.path("out.npz");
    const std::vector<float> values(4, 1.0F);
    const std::array arrays{NpzArray("left", {1, 2, 2}, std::span(values)),
                            NpzArray("right", {1, 2, 2}, std::span(values))};
    ASSERT_TRUE(writeNpz(path, arrays));
    FrameRequest request = atOneHertz();
    request.path = path;
    const auto all = teleta::frames::readFrames(request);
    ASSERT_FALSE(all);
    EXPECT_NE(describe(all.error()).find("left (1 x 2 x 2), right (1 x 2 x 2)"), std::string::npos);
    EXPECT_EQ(teleta::frames::arraysIn(path), (std::vector<std::string>{"left", "right"}));
    EXPECT_TRUE(teleta::frames::arraysIn(m_folder.write("table.csv", "time_s,t0\n0,1\n")).empty());
    EXPECT_TRUE(teleta::frames::arraysIn(m_folder.path("none.npz")).empty());
    request.array = "right";
    EXPECT_TRUE(teleta::frames::readFrames(request));
    request.array = "middle";
    EXPECT_FALSE(teleta::frames::readFrames(request));
}
