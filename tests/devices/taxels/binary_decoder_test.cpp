// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/frame_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <set>
#include <vector>

namespace teleta::taxels {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Framing = FrameDecoder::Framing;
using Rest = FrameDecoder::Rest;

void append(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// 7E 5A, a counter, two numbers with the high byte first, and the sum of all these.
BinaryFormat summed() {
    BinaryFormat format;
    format.sync = {0x7E, 0x5A};
    format.length = 8;
    format.checksum = {.type = ChecksumType::sum8, .at = -1, .from = 0, .to = -1};
    format.counter = NumberField{.at = 2};
    format.values = {.field = {.at = 3, .type = NumberType::int16, .order = ByteOrder::big}, .count = 2};
    format.scaling = {.scale = 0.5, .offset = 1.0};
    format.end = {};
    return format;
}

Bytes summedFrame(std::uint8_t counter, std::int16_t a, std::int16_t b) {
    const auto high = [](std::int16_t value) {
        return static_cast<std::uint8_t>(static_cast<std::uint16_t>(value) >> 8);
    };
    Bytes bytes{
        0x7E, 0x5A, counter, high(a), static_cast<std::uint8_t>(a), high(b), static_cast<std::uint8_t>(b)};
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes)
        sum += byte;
    bytes.push_back(static_cast<std::uint8_t>(sum));
    return bytes;
}

/// As AnySkin sends it: per chip four floats, then carriage return and line feed.
BinaryFormat skin(std::size_t chips) {
    BinaryFormat format;
    format.end = {0x0D, 0x0A};
    format.length = 16 * chips + 2;
    format.values = {.field = {.at = 4, .type = NumberType::float32},
                     .count = 3 * chips,
                     .perGroup = 3,
                     .stride = 16,
                     .low = -1e6,
                     .high = 1e6};
    format.others = {{.field = {.at = 0, .type = NumberType::float32},
                      .count = chips,
                      .perGroup = 1,
                      .stride = 16,
                      .low = -40.0,
                      .high = 125.0}};
    return format;
}

Bytes skinFrame(std::size_t chips, float first) {
    Bytes bytes;
    const auto put = [&](float value) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int i = 0; i < 4; ++i)
            bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    };
    for (std::size_t chip = 0; chip < chips; ++chip) {
        put(25.0F + static_cast<float>(chip));
        for (int axis = 0; axis < 3; ++axis)
            put(first + static_cast<float>(chip) + 0.25F * static_cast<float>(axis));
    }
    append(bytes, {0x0D, 0x0A});
    return bytes;
}

struct Decoded {
    std::vector<std::vector<float>> values;
    std::vector<std::uint32_t> counters;
    std::vector<std::uint64_t> places;
};

Decoded decode(FrameDecoder& decoder, const Bytes& bytes, std::size_t piece, bool atEnd = true) {
    Decoded found;
    DecodedFrame frame;
    const auto drain = [&](Rest rest) {
        while (decoder.next(frame, rest)) {
            found.values.push_back(frame.values);
            found.counters.push_back(frame.counter.value_or(0));
            found.places.push_back(decoder.frameBegin());
        }
    };
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
        decoder.feed(std::span(bytes).subspan(begin, std::min(piece, bytes.size() - begin)));
        drain(Rest::mayCome);
    }
    if (atEnd)
        drain(Rest::willNotCome);
    return found;
}

TEST(BinaryDecoder, readsNumbersWithTheirScale) {
    const auto decoder = makeDecoder(summed(), Framing::stream);
    const Decoded found = decode(*decoder, summedFrame(9, -2, 300), 1);
    ASSERT_EQ(found.values.size(), 1U);
    EXPECT_EQ(found.values[0], (std::vector<float>{0.0F, 151.0F}));
    EXPECT_EQ(found.counters[0], 9U);
}

TEST(BinaryDecoder, readsEachTypeOfNumber) {
    struct Case {
        NumberType type;
        ByteOrder order;
        Bytes bytes;
        double value;
    };
    const std::vector<Case> cases{
        {NumberType::int8, ByteOrder::little, {0xFF}, -1.0},
        {NumberType::uint8, ByteOrder::little, {0xFF}, 255.0},
        {NumberType::int16, ByteOrder::little, {0x00, 0x80}, -32768.0},
        {NumberType::uint16, ByteOrder::big, {0x01, 0x02}, 258.0},
        {NumberType::int24, ByteOrder::big, {0xFF, 0xFF, 0xFE}, -2.0},
        {NumberType::uint24, ByteOrder::little, {0x01, 0x02, 0x03}, 197121.0},
        {NumberType::int32, ByteOrder::little, {0xFE, 0xFF, 0xFF, 0xFF}, -2.0},
        {NumberType::uint32, ByteOrder::big, {0xFF, 0xFF, 0xFF, 0xFF}, 4294967295.0},
        {NumberType::float32, ByteOrder::big, {0xC0, 0x49, 0x0F, 0xDB}, -3.1415927410125732},
        {NumberType::float64,
         ByteOrder::little,
         {0x18, 0x2D, 0x44, 0x54, 0xFB, 0x21, 0x09, 0x40},
         3.141592653589793}};
    for (const Case& known : cases) {
        EXPECT_EQ(readNumber(known.bytes, known.type, known.order), known.value);
        EXPECT_EQ(sizeOf(known.type), known.bytes.size());
    }
}

TEST(BinaryDecoder, keepsEachWholeFrameBetweenDamagedOnesHoweverTheBytesAreCut) {
    std::mt19937 random(7);
    Bytes stream;
    std::set<std::uint32_t> whole;
    for (int number = 0; number < 250; ++number) {
        Bytes frame =
            summedFrame(static_cast<std::uint8_t>(number), static_cast<std::int16_t>(3 * number), -7);
        const unsigned fate = random() % 5;
        if (fate == 0)
            frame[random() % frame.size()] ^= 0x10;
        else if (fate == 1)
            frame.resize(random() % frame.size());
        else
            whole.insert(static_cast<std::uint32_t>(number));
        if (fate == 2)
            append(stream, {0x7E, 0x5A, 0x7E});
        append(stream, frame);
    }
    std::vector<std::uint64_t> places;
    for (const std::size_t piece : {std::size_t{1}, std::size_t{5}, stream.size()}) {
        const auto decoder = makeDecoder(summed(), Framing::stream);
        const Decoded found = decode(*decoder, stream, piece);
        for (const std::uint32_t number : whole)
            EXPECT_EQ(std::ranges::count(found.counters, number), 1) << number << " in pieces of " << piece;
        const FrameDecoder::Counters& counted = decoder->counters();
        EXPECT_EQ(counted.frameBytes + counted.droppedBytes, stream.size());
        EXPECT_EQ(decoder->pendingBytes(), 0U);
        EXPECT_GT(counted.badChecksums, 0U);
        if (places.empty())
            places = found.places;
        EXPECT_EQ(found.places, places) << "what is found does not depend on how the bytes were cut";
    }
}

TEST(BinaryDecoder, takesTheLengthFromTheFrameAndPassesOverFramesOfOtherLengths) {
    for (const auto counts :
         {LengthField::Counts::payload, LengthField::Counts::rest, LengthField::Counts::frame}) {
        BinaryFormat format;
        format.sync = {0xAA, 0x55};
        format.end = {0x0A};
        format.lengthField = LengthField{.field = {.at = 2, .type = NumberType::uint8}, .counts = counts};
        format.checksum = {.type = ChecksumType::xor8, .at = -2, .from = 2, .to = -2};
        format.values = {.field = {.at = 3, .type = NumberType::uint8}, .count = 3};
        const auto frame = [&](const Bytes& payload) {
            const std::size_t n = payload.size();
            const std::size_t number = counts == LengthField::Counts::payload ? n
                                       : counts == LengthField::Counts::rest  ? n + 2
                                                                              : n + 5;
            Bytes bytes{0xAA, 0x55, static_cast<std::uint8_t>(number)};
            append(bytes, payload);
            std::uint8_t check = 0;
            for (std::size_t i = 2; i < bytes.size(); ++i)
                check ^= bytes[i];
            append(bytes, {check, 0x0A});
            return bytes;
        };
        Bytes stream = frame({1, 2, 3});
        append(stream, frame({9})); // an answer to something
        append(stream, frame({4, 5, 6}));
        append(stream, {0xAA, 0x55, 0x00}); // a length that no frame of this kind has, when all bytes count
        append(stream, frame({7, 8, 9}));
        const auto decoder = makeDecoder(format, Framing::stream);
        const Decoded found = decode(*decoder, stream, 4);
        EXPECT_EQ(found.values, (std::vector<std::vector<float>>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
        EXPECT_EQ(decoder->counters().otherFrames, 1U);
        EXPECT_EQ(decoder->counters().frames, 3U);
    }
}

TEST(BinaryDecoder, countsThePayloadUpToAChecksumThatIsNotTheLast) {
    BinaryFormat format;
    format.sync = {0xAA, 0x55};
    format.lengthField =
        LengthField{.field = {.at = 2, .type = NumberType::uint8}, .counts = LengthField::Counts::payload};
    format.checksum = {.type = ChecksumType::sum8, .at = -3, .from = 3, .to = -3};
    format.values = {.field = {.at = 3, .type = NumberType::uint8}, .count = 2};
    const Bytes stream{0xAA, 0x55, 2, 1, 2, 3, 0x90, 0x91, 0xAA, 0x55, 2, 5, 6, 11, 0x92, 0x93};
    const auto decoder = makeDecoder(format, Framing::stream);
    const Decoded found = decode(*decoder, stream, 3);
    EXPECT_EQ(found.values, (std::vector<std::vector<float>>{{1, 2}, {5, 6}}));
    EXPECT_EQ(decoder->counters().droppedBytes, 0U);
}

TEST(BinaryDecoder, believesFramesWithoutAHeaderOnlyAfterTwoInARow) {
    constexpr std::size_t kChips = 5;
    Bytes stream = skinFrame(kChips, 100.0F);
    stream.erase(stream.begin(), stream.begin() + 30); // it begins in the middle of a frame
    for (int i = 1; i <= 4; ++i)
        append(stream, skinFrame(kChips, 100.0F * static_cast<float>(i)));
    Bytes wrong = skinFrame(kChips, 0.0F);
    wrong[3] = 0x7F; // a temperature of 1e38
    append(stream, wrong);
    for (int i = 5; i <= 7; ++i)
        append(stream, skinFrame(kChips, 100.0F * static_cast<float>(i)));
    const auto decoder = makeDecoder(skin(kChips), Framing::stream);
    const Decoded found = decode(*decoder, stream, 17);
    ASSERT_EQ(found.values.size(), 7U);
    for (int i = 1; i <= 7; ++i)
        EXPECT_EQ(found.values[static_cast<std::size_t>(i - 1)][0], 100.0F * static_cast<float>(i));
    EXPECT_EQ(found.values[0][3], 101.0F) << "x of the second chip";
    EXPECT_EQ(found.values[0][15], 25.0F) << "the temperatures come behind";
    EXPECT_EQ(found.values[0][19], 29.0F);
}

TEST(BinaryDecoder, locksOntoNoWrongPlaceOfRandomStarts) {
    constexpr std::size_t kChips = 5;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> field(-5000.0F, 5000.0F);
    Bytes stream;
    for (int i = 0; i < 400; ++i)
        append(stream, skinFrame(kChips, field(random)));
    constexpr std::size_t kFrame = 16 * kChips + 2;
    for (std::size_t start = 0; start < 4000; ++start) {
        const auto decoder = makeDecoder(skin(kChips), Framing::stream);
        decoder->feed(std::span(stream).subspan(start, 4 * kFrame));
        DecodedFrame frame;
        ASSERT_TRUE(decoder->next(frame));
        ASSERT_EQ((start + decoder->frameBegin()) % kFrame, 0U) << start;
    }
}

TEST(BinaryDecoder, takesASingleFrameOnceTheLineIsSilent) {
    const auto decoder = makeDecoder(skin(2), Framing::stream);
    DecodedFrame frame;
    decoder->feed(skinFrame(2, 1.0F));
    EXPECT_FALSE(decoder->next(frame));
    EXPECT_TRUE(decoder->next(frame, Rest::willNotCome));
    Bytes more = skinFrame(2, 2.0F);
    append(more, {0x00});
    const auto other = makeDecoder(skin(2), Framing::stream);
    other->feed(more);
    EXPECT_FALSE(other->next(frame, Rest::willNotCome)) << "something else stands behind it";
    EXPECT_EQ(other->pendingBytes(), 0U);
}

TEST(BinaryDecoder, takesADatagramForOneFrameOrNone) {
    const auto decoder = makeDecoder(summed(), Framing::datagrams);
    DecodedFrame frame;
    const auto takes = [&](const Bytes& datagram) {
        decoder->feed(datagram);
        const bool isFrame = decoder->next(frame);
        EXPECT_FALSE(decoder->next(frame));
        EXPECT_EQ(decoder->pendingBytes(), 0U);
        return isFrame;
    };
    EXPECT_TRUE(takes(summedFrame(1, 2, 3)));
    Bytes two = summedFrame(2, 2, 3);
    append(two, summedFrame(3, 2, 3));
    EXPECT_FALSE(takes(two));
    Bytes behind{0x00};
    append(behind, summedFrame(4, 2, 3));
    EXPECT_FALSE(takes(behind));
    EXPECT_FALSE(takes({0x7E}));
    EXPECT_TRUE(takes(summedFrame(5, 2, 3)));
    EXPECT_EQ(decoder->counters().frames, 2U);
    EXPECT_EQ(decoder->counters().droppedBytes, 16U + 9U + 1U);
}

} // namespace
} // namespace teleta::taxels
