// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_decoder.h"
#include "tests/devices/wts/wts_messages.h"
#include "tests/fuzz/fuzz_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>

namespace teleta::wts {
namespace {

using test::append;
using test::Bytes;
using Rest = MessageDecoder::Rest;

struct Copy {
    unsigned id = 0;
    Bytes payload;

    bool operator==(const Copy&) const = default;
};

void drain(MessageDecoder& decoder, std::vector<Copy>& copies, Rest rest = Rest::mayCome) {
    Message message;
    while (decoder.next(message, rest))
        copies.push_back({message.id, Bytes(message.payload.begin(), message.payload.end())});
}

std::vector<Copy> decode(MessageDecoder& decoder, const Bytes& bytes, Rest rest = Rest::mayCome) {
    std::vector<Copy> copies;
    decoder.feed(bytes);
    drain(decoder, copies, rest);
    return copies;
}

const Bytes kPayload{1, 2, 3, 4, 5};
const Copy kCopy{0x30, kPayload};
const Bytes kMessage = test::message(0x30, kPayload);

Bytes joined(std::initializer_list<Bytes> parts) {
    Bytes bytes;
    for (const Bytes& part : parts)
        append(bytes, part);
    return bytes;
}

Bytes text(std::string_view characters) {
    return {characters.begin(), characters.end()};
}

TEST(WtsDecoder, findsMessagesThatAreGluedTogether) {
    MessageDecoder decoder;
    EXPECT_EQ(decode(decoder, joined({kMessage, kMessage, test::message(0x00, {})})),
              (std::vector<Copy>{kCopy, kCopy, {0x00, {}}}));
    EXPECT_EQ(decoder.counters(), (MessageDecoder::Counters{3, 2 * kMessage.size() + 8, 0, 0, 0}));
}

TEST(WtsDecoder, waitsForTheRestOfAMessage) {
    MessageDecoder decoder;
    std::vector<Copy> copies;
    for (std::size_t i = 0; i < kMessage.size(); ++i) {
        EXPECT_TRUE(copies.empty());
        decoder.feed(std::span(kMessage).subspan(i, 1));
        drain(decoder, copies);
    }
    EXPECT_EQ(copies, std::vector<Copy>{kCopy});
    EXPECT_EQ(decoder.counters().droppedBytes, 0U);
}

TEST(WtsDecoder, passesOverBootNoise) {
    const Bytes noise = text("\r\nWTS boot 1.02\r\n\xAA\xAA ready \xAA");
    MessageDecoder decoder;
    EXPECT_EQ(decode(decoder, joined({noise, text("."), kMessage})), std::vector<Copy>{kCopy});
    EXPECT_EQ(decoder.counters().droppedBytes, noise.size() + 1);
}

TEST(WtsDecoder, takesTheLastThreeOfManyPreambleBytes) {
    for (std::size_t surplus = 1; surplus <= 9; ++surplus) {
        MessageDecoder decoder;
        EXPECT_EQ(decode(decoder, joined({Bytes(surplus, 0xAA), kMessage})), std::vector<Copy>{kCopy});
        EXPECT_EQ(decoder.counters().droppedBytes, surplus);
    }
}

TEST(WtsDecoder, readsPreambleBytesInsideThePayload) {
    const Bytes payload = joined({Bytes(7, 0xAA), {0x00, 0x02, 0x00, 0x01}, Bytes(4, 0xAA)});
    MessageDecoder decoder;
    EXPECT_EQ(decode(decoder, joined({test::message(0x00, payload), kMessage})),
              (std::vector<Copy>{{0x00, payload}, kCopy}));
    EXPECT_EQ(decoder.counters().droppedBytes, 0U);
}

TEST(WtsDecoder, dropsAMessageWithAWrongChecksumAndFindsTheNext) {
    Bytes damaged = kMessage;
    damaged[8] ^= 0x10;
    MessageDecoder decoder;
    EXPECT_EQ(decode(decoder, joined({damaged, kMessage})), std::vector<Copy>{kCopy});
    EXPECT_EQ(decoder.counters().badChecksums, 1U);
    EXPECT_EQ(decoder.counters().droppedBytes, damaged.size());
}

TEST(WtsDecoder, findsAMessageBehindACutOne) {
    for (std::size_t length = 1; length < kMessage.size(); ++length) {
        MessageDecoder decoder;
        const Bytes cut(kMessage.begin(), kMessage.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_EQ(decode(decoder, joined({cut, kMessage, kMessage})), (std::vector<Copy>{kCopy, kCopy}))
            << length;
        EXPECT_EQ(decoder.counters().droppedBytes, length);
    }
}

TEST(WtsDecoder, findsAMessageThatACutOneSwallowsOnceTheLineIsSilent) {
    Bytes header{0xAA, 0xAA, 0xAA, 0x00};
    test::appendU16(header, 200);
    MessageDecoder decoder;
    EXPECT_TRUE(decode(decoder, joined({header, kMessage})).empty());
    std::vector<Copy> copies;
    drain(decoder, copies, Rest::willNotCome);
    EXPECT_EQ(copies, std::vector<Copy>{kCopy});
    EXPECT_EQ(decoder.pendingBytes(), 0U);
}

TEST(WtsDecoder, doesNotWaitForASizeThatNoMessageHas) {
    Bytes header{0xAA, 0xAA, 0xAA, 0x00};
    test::appendU16(header, 6);
    MessageDecoder decoder;
    decoder.setMaximumPayload(5);
    EXPECT_EQ(decode(decoder, joined({header, kMessage})), std::vector<Copy>{kCopy});
    EXPECT_EQ(decoder.counters().badSizes, 1U);
}

TEST(WtsDecoder, readsTheLargestMessage) {
    const Bytes payload(65535, 0x5A);
    MessageDecoder decoder;
    decoder.setMaximumPayload(65535);
    EXPECT_EQ(decode(decoder, test::message(0x00, payload)), (std::vector<Copy>{{0x00, payload}}));
}

TEST(WtsDecoder, noticesEverySingleWrongBit) {
    for (std::size_t bit = 0; bit < 8 * kMessage.size(); ++bit) {
        Bytes damaged = kMessage;
        damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        MessageDecoder decoder;
        EXPECT_TRUE(decode(decoder, damaged, Rest::willNotCome).empty()) << bit;
    }
}

/// Streams of messages, of which a share is damaged in every way that a line and a sensor know.
class Mutator {
public:
    struct Stream {
        Bytes bytes;
        std::vector<Copy> untouched;
    };

    explicit Mutator(unsigned seed)
        : m_random(seed) {}

    unsigned below(unsigned end) { return static_cast<unsigned>(m_random() % end); }

    Stream stream(unsigned messages) {
        Stream stream;
        for (unsigned i = 0; i < messages; ++i) {
            const Copy copy{kIds[below(kIds.size())], payload()};
            Bytes bytes = test::message(copy.id, copy.payload);
            if (below(3) == 0)
                damage(bytes);
            else
                stream.untouched.push_back(copy);
            append(stream.bytes, bytes);
        }
        return stream;
    }

private:
    static constexpr std::array<unsigned, 5> kIds{0x00, 0x00, 0x21, 0x30, 0x46};

    Bytes payload() {
        Bytes bytes(below(4) == 0 ? below(4) : below(181));
        const bool preambles = below(4) == 0;
        for (std::uint8_t& byte : bytes)
            byte = preambles && below(2) == 0 ? 0xAA : static_cast<std::uint8_t>(m_random());
        return bytes;
    }

    void insert(Bytes& bytes, std::size_t place, const Bytes& more) {
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place), more.begin(), more.end());
    }

    void damage(Bytes& bytes) {
        const unsigned size = static_cast<unsigned>(bytes.size());
        switch (below(7)) {
        case 0: // noise on the line
            bytes[below(size)] ^= static_cast<std::uint8_t>(1 + below(255));
            break;
        case 1: // a lost byte
            bytes.erase(bytes.begin() + below(size));
            break;
        case 2: // cut off
            bytes.resize(below(size));
            break;
        case 3: // a surplus preamble inside
            insert(bytes, 1 + below(size - 1), Bytes(1 + below(5), 0xAA));
            break;
        case 4: // a wrong size with a right checksum
            bytes.resize(bytes.size() - 2);
            bytes[4] = static_cast<std::uint8_t>(bytes[4] ^ (1 + below(255)));
            bytes = test::sealed(std::move(bytes));
            break;
        case 5: // a wrong checksum
            bytes.back() ^= static_cast<std::uint8_t>(1 + below(255));
            break;
        default: // the sensor booted
            bytes.resize(below(size));
            append(bytes, text("\r\nWTS bootloader 1.2\r\n"));
        }
    }

    std::mt19937 m_random;
};

/// The untouched messages must come out, in their order; more may come out where damage left a whole one.
bool isSubsequence(const std::vector<Copy>& part, const std::vector<Copy>& whole) {
    auto at = whole.begin();
    for (const Copy& copy : part) {
        at = std::find(at, whole.end(), copy);
        if (at == whole.end())
            return false;
        ++at;
    }
    return true;
}

class WtsDecoderUnderDamage : public testing::TestWithParam<unsigned> {};

TEST_P(WtsDecoderUnderDamage, losesNoWholeMessageAndNoByteOfItsAccount) {
    Mutator mutator(GetParam());
    for (int round = 0; round < 40; ++round) {
        const Mutator::Stream stream = mutator.stream(60);
        MessageDecoder decoder;
        std::vector<Copy> copies;
        for (std::size_t begin = 0; begin < stream.bytes.size();) {
            const std::size_t count =
                std::min<std::size_t>(1 + mutator.below(300), stream.bytes.size() - begin);
            decoder.feed(std::span(stream.bytes).subspan(begin, count));
            drain(decoder, copies);
            begin += count;
            const MessageDecoder::Counters& counted = decoder.counters();
            ASSERT_EQ(counted.messageBytes + counted.droppedBytes + decoder.pendingBytes(), begin);
        }
        drain(decoder, copies, Rest::willNotCome);
        ASSERT_EQ(decoder.pendingBytes(), 0U);
        ASSERT_EQ(decoder.counters().messages, copies.size());
        ASSERT_GT(decoder.counters().badChecksums, 0U);
        ASSERT_TRUE(isSubsequence(stream.untouched, copies)) << "seed " << GetParam() << " round " << round;
    }
}

TEST_P(WtsDecoderUnderDamage, findsTheSameHoweverTheStreamIsCut) {
    Mutator mutator(GetParam() + 1000);
    const Mutator::Stream stream = mutator.stream(200);
    MessageDecoder whole;
    const std::vector<Copy> expected = decode(whole, stream.bytes);
    for (const std::size_t chunk : {1U, 7U, 64U}) {
        MessageDecoder decoder;
        std::vector<Copy> copies;
        for (std::size_t begin = 0; begin < stream.bytes.size(); begin += chunk) {
            decoder.feed(
                std::span(stream.bytes).subspan(begin, std::min(chunk, stream.bytes.size() - begin)));
            drain(decoder, copies);
        }
        EXPECT_EQ(copies, expected);
        EXPECT_EQ(decoder.counters(), whole.counters());
    }
}

/// What the fuzzer looks for, on inputs that are the same each time: damaged streams, and bytes in which
/// preambles and headers are frequent.
TEST_P(WtsDecoderUnderDamage, keepsItsAccountAndItsCellsForAnyBytes) {
    Mutator mutator(GetParam() + 2000);
    for (int round = 0; round < 20; ++round) {
        const Bytes bytes = mutator.stream(20).bytes;
        (void)fuzz::wtsFrames(bytes);
    }
    constexpr std::array<std::uint8_t, 6> kFrequent{0xAA, 0xAA, 0xAA, 0x00, 0x01, 0x05};
    for (int round = 0; round < 2000; ++round) {
        Bytes bytes(mutator.below(600));
        for (std::uint8_t& byte : bytes)
            byte = mutator.below(3) != 0 ? kFrequent[mutator.below(kFrequent.size())]
                                         : static_cast<std::uint8_t>(mutator.below(256));
        (void)fuzz::wtsFrames(bytes);
        // Behind a right header and checksum any bytes are a payload.
        bytes.resize(std::min<std::size_t>(bytes.size(), 250));
        const Bytes message = test::message(mutator.below(2) == 0 ? 0x00 : 0x30, bytes);
        EXPECT_TRUE(fuzz::wtsFrames(message));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, WtsDecoderUnderDamage, testing::Values(1U, 2U, 3U, 4U, 5U, 6U));

} // namespace
} // namespace teleta::wts
