// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_codec.h"
#include "tests/devices/wts/wts_messages.h"

#include <gtest/gtest.h>

#include <array>

namespace teleta::wts {
namespace {

using test::Bytes;
using test::framePayload;

/// The vectors of the sensor's protocol: message, then its checksum as it is sent.
TEST(WtsCodec, computesTheChecksumsOfTheProtocol) {
    EXPECT_EQ(checksum(Bytes{0xAA, 0xAA, 0xAA, 0x01, 0x02, 0x00, 0x12, 0x34}), 0x666D);
    EXPECT_EQ(checksum(Bytes{0xAA, 0xAA, 0xAA, 0x01, 0x00, 0x00}), 0x10E8);
    EXPECT_EQ(checksum(Bytes{0xAA, 0xAA, 0xAA, 0x06, 0x00, 0x00}), 0x2697);
}

TEST(WtsCodec, encodesRequestsAsTheProtocolDoes) {
    EXPECT_EQ(encodeRequest(Command::loop), (Bytes{0xAA, 0xAA, 0xAA, 0x06, 0x00, 0x00, 0x97, 0x26}));
    const Bytes params{0x12, 0x34};
    EXPECT_EQ(encodeRequest(static_cast<Command>(0x01), params),
              (Bytes{0xAA, 0xAA, 0xAA, 0x01, 0x02, 0x00, 0x12, 0x34, 0x6D, 0x66}));
    EXPECT_EQ(encodeStartFrames(true, 0x0114),
              test::sealed({0xAA, 0xAA, 0xAA, 0x21, 0x03, 0x00, 0x01, 0x14, 0x01}));
    EXPECT_EQ(encodeStartFrames(false, 0),
              test::sealed({0xAA, 0xAA, 0xAA, 0x21, 0x03, 0x00, 0x00, 0x00, 0x00}));
}

TEST(WtsCodec, readsStatusAndParametersOfAnAnswer) {
    const Bytes payload{0x0E, 0x00, 0x07};
    const auto answer = readAnswer({0x23, payload});
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, Status::unknownCommand);
    ASSERT_EQ(answer->params.size(), 1U);
    EXPECT_EQ(answer->params[0], 0x07);
}

TEST(WtsCodec, keepsTheNumberOfAStatusWithoutAName) {
    const Bytes payload{0x34, 0x12};
    EXPECT_EQ(static_cast<int>(readAnswer({0x23, payload})->status), 0x1234);
}

TEST(WtsCodec, refusesAnAnswerWithoutAStatus) {
    const Bytes payload{0x00};
    EXPECT_FALSE(readAnswer({0x23, payload}));
    EXPECT_FALSE(readAnswer({0x23, {}}));
}

TEST(WtsCodec, readsTheMatrixInfoOfAWts0614) {
    const auto info = readMatrixInfo(Bytes{0x0E, 0, 0x06, 0, 0x54, 0x01, 0x54, 0x01, 0xFF, 0x0F});
    ASSERT_TRUE(info);
    EXPECT_EQ(*info, (MatrixInfo{14, 6, 340, 340, 4095}));
    EXPECT_EQ(info->cells(), 84U);
}

TEST(WtsCodec, refusesAMatrixInfoOfAnotherSize) {
    EXPECT_FALSE(readMatrixInfo(Bytes(9)));
    EXPECT_FALSE(readMatrixInfo(Bytes(11)));
    EXPECT_FALSE(readMatrixInfo({}));
}

class WtsFrame : public testing::Test {
protected:
    FrameFault faultOf(const Bytes& payload) {
        const auto timestamp = readFrame(payload, m_cells);
        EXPECT_FALSE(timestamp);
        return timestamp ? static_cast<FrameFault>(-1) : timestamp.error();
    }

    std::array<float, 20> m_cells{};
};

TEST_F(WtsFrame, readsCellsWithAllTheirBits) {
    std::vector<unsigned> words;
    for (unsigned i = 0; i < 20; ++i)
        words.push_back(0xFFFF - i * 3000);
    const auto timestamp = readFrame(framePayload(0xFEDCBA98, false, words), m_cells);
    ASSERT_TRUE(timestamp);
    EXPECT_EQ(*timestamp, 0xFEDCBA98U);
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_EQ(m_cells[i], static_cast<float>(words[i]));
}

TEST_F(WtsFrame, spreadsRunsOverTheirCells) {
    ASSERT_TRUE(readFrame(framePayload(1, true, {0xF123, 0x1FFF, 0x4000}), m_cells));
    for (std::size_t i = 0; i < 15; ++i)
        EXPECT_EQ(m_cells[i], 0x123) << i;
    EXPECT_EQ(m_cells[15], 0xFFF);
    for (std::size_t i = 16; i < 20; ++i)
        EXPECT_EQ(m_cells[i], 0) << i;
}

TEST_F(WtsFrame, refusesARunOfNoCells) {
    EXPECT_EQ(faultOf(framePayload(1, true, {0xF123, 0x0000, 0x5000})), FrameFault::emptyRun);
    EXPECT_EQ(faultOf(framePayload(1, true, {0xF123, 0x5000, 0x0FFF})), FrameFault::emptyRun);
}

TEST_F(WtsFrame, refusesOneCellTooFewOrTooMany) {
    EXPECT_EQ(faultOf(framePayload(1, true, {0xF123, 0x4000})), FrameFault::tooFewCells);
    EXPECT_EQ(faultOf(framePayload(1, true, {0xF123, 0x6000})), FrameFault::tooManyCells);
    EXPECT_EQ(faultOf(framePayload(1, true, {0xF123, 0x5000, 0x1000})), FrameFault::tooManyCells);
    EXPECT_EQ(faultOf(framePayload(1, false, std::vector<unsigned>(19))), FrameFault::tooFewCells);
    EXPECT_EQ(faultOf(framePayload(1, false, std::vector<unsigned>(21))), FrameFault::tooManyCells);
    EXPECT_EQ(faultOf(framePayload(1, false, {})), FrameFault::tooFewCells);
}

TEST_F(WtsFrame, refusesHalfACellAndACutHeader) {
    Bytes payload = framePayload(1, false, std::vector<unsigned>(20));
    payload.pop_back();
    EXPECT_EQ(faultOf(payload), FrameFault::oddSize);
    payload.resize(4);
    EXPECT_EQ(faultOf(payload), FrameFault::tooShort);
    EXPECT_EQ(faultOf({}), FrameFault::tooShort);
}

} // namespace
} // namespace teleta::wts
