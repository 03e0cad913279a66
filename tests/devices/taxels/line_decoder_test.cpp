// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/frame_decoder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::taxels {
namespace {

using Framing = FrameDecoder::Framing;
using Rest = FrameDecoder::Rest;
using Frames = std::vector<std::vector<float>>;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Frames decode(FrameDecoder& decoder, const std::string& text, Rest rest = Rest::mayCome) {
    Frames found;
    DecodedFrame frame;
    for (const char letter : text) {
        decoder.feed(bytesOf(std::string(1, letter)));
        while (decoder.next(frame))
            found.push_back(frame.values);
    }
    while (decoder.next(frame, rest))
        found.push_back(frame.values);
    const FrameDecoder::Counters& counted = decoder.counters();
    EXPECT_EQ(counted.frameBytes + counted.droppedBytes + decoder.pendingBytes(), text.size());
    return found;
}

TEST(LineDecoder, readsColumnsOfLines) {
    const auto decoder = makeDecoder(
        CsvFormat{.skip = 1, .firstColumn = 2, .lastColumn = 3, .timeColumn = 1, .scaling = {2.0, 1.0}},
        Framing::stream);
    const Frames found =
        decode(*decoder, "5,7\n0.1,1,2,9\r\n\n0.2, 3 ,+4\n0.3,5\n0.4,x,1\n0.5,nan,1\n0.6,6,7");
    EXPECT_EQ(found, (Frames{{3, 5}, {7, 9}}));
    EXPECT_EQ(decoder->counters().badValues, 3U);
    DecodedFrame frame;
    ASSERT_TRUE(decoder->next(frame, Rest::ended)) << "the last line of a file may lack its end";
    EXPECT_EQ(frame.values, (std::vector<float>{13, 15}));
    EXPECT_DOUBLE_EQ(frame.time_s.value_or(0.0), 0.6);
}

TEST(LineDecoder, dropsALineOfNumbersThatIsCut) {
    const auto decoder = makeDecoder(CsvFormat{.lastColumn = 1}, Framing::stream);
    EXPECT_EQ(decode(*decoder, "5\n12", Rest::willNotCome), (Frames{{5}}));
    EXPECT_EQ(decoder->counters().badValues, 1U);
    EXPECT_EQ(decoder->pendingBytes(), 0U);
    DecodedFrame frame;
    decoder->feed(bytesOf("3\n6\n\r"));
    ASSERT_TRUE(decoder->next(frame, Rest::willNotCome));
    EXPECT_EQ(frame.values, std::vector<float>{6}) << "not the rest of the line";
    EXPECT_FALSE(decoder->next(frame, Rest::willNotCome));
    decoder->feed(bytesOf("7\n\r"));
    ASSERT_TRUE(decoder->next(frame)) << "no line begins with a carriage return alone";
    EXPECT_EQ(frame.values, std::vector<float>{7});
    EXPECT_EQ(decoder->counters().badValues, 1U);
}

TEST(LineDecoder, readsOtherSeparators) {
    const auto decoder = makeDecoder(CsvFormat{.separator = '\t', .lastColumn = 2}, Framing::stream);
    EXPECT_EQ(decode(*decoder, "1\t2\n-3e2\t4\n+-5\t4\n"), (Frames{{1, 2}, {-300, 4}}));
    EXPECT_EQ(decoder->counters().badValues, 1U) << "a number has one sign";
}

TEST(LineDecoder, readsNumbersOutOfJson) {
    const auto decoder =
        makeDecoder(JsonFormat{.values = "/sensors/0/data", .time = "/t", .timeUnit_s = 1e-3, .count = 2},
                    Framing::stream);
    const Frames found = decode(*decoder, R"({"t":5,"sensors":[{"data":[1,2.5]}]})"
                                          "\n"
                                          R"({"message":"Welcome"})"
                                          "\n"
                                          R"({"t":6,"sensors":[{"data":[1]}]})"
                                          "\n"
                                          R"({"t":6,"sensors":[{"data":[1,"2"]}]})"
                                          "\n"
                                          R"({"t":6,"sensors":[{"data":[1,2]}])"
                                          "\n"
                                          R"({"sensors":[{"data":[1,2]}]})"
                                          "\n"
                                          R"({"t":7,"sensors":[{"data":[-1,0]}]})"
                                          "\n");
    EXPECT_EQ(found, (Frames{{1, 2.5}, {-1, 0}}));
    EXPECT_EQ(decoder->counters().badValues, 4U);
    EXPECT_EQ(decoder->counters().otherFrames, 1U) << "the greeting";
}

TEST(LineDecoder, readsHexadecimalTextAsOfXela) {
    const auto decoder =
        makeDecoder(JsonFormat{.values = "/1/data", .hex = true, .count = 3}, Framing::stream);
    EXPECT_EQ(decode(*decoder, "{\"1\":{\"data\":\"FA00, fb00,0001\"}}\n{\"1\":{\"data\":\"FA00,10000,1\"}}\n"
                               "{\"1\":{\"data\":\"FA00,,1\"}}\n{\"1\":{\"data\":[1,2,3]}}\n"),
              (Frames{{64000, 64256, 1}}));
    EXPECT_EQ(decoder->counters().badValues, 3U);
}

TEST(LineDecoder, checksWhatASensorSaysOfItself) {
    using Problem = FrameDecoder::Problem;
    const auto decoder = makeDecoder(JsonFormat{.values = "/1/f",
                                                .time = "/t",
                                                .otherTime = "/1/t",
                                                .mayLackTime = true,
                                                .sensor = JsonSensor{"/1", 1, {}},
                                                .count = 3},
                                     Framing::datagrams);
    const auto problemOf = [&](const std::string& text) {
        DecodedFrame frame;
        decoder->feed(bytesOf(text));
        EXPECT_FALSE(decoder->next(frame)) << text;
        return decoder->problem();
    };
    DecodedFrame frame;
    decoder->feed(bytesOf(R"({"1":{"model":"A","taxels":1,"f":[1,2,3],"t":0.5},"2":{"f":[NaN,-Infinity]}})"));
    ASSERT_TRUE(decoder->next(frame)) << "only the other sensor tells no numbers";
    EXPECT_EQ(frame.time_s, 0.5) << "the sensor's, where the document has none";
    EXPECT_EQ(decoder->problem(), Problem());

    EXPECT_EQ(problemOf(R"({"1":{"model":"B","taxels":1,"f":[1,2,3]}})"),
              (Problem{Problem::Kind::model, "B", "A"}));
    EXPECT_EQ(problemOf(R"({"message":"Welcome"})").kind, Problem::Kind::model) << "of the newest frame";
    EXPECT_EQ(problemOf(R"({"1":{"model":"A","taxels":2,"f":[1,2,3]}})"),
              (Problem{Problem::Kind::taxels, "2", "1"}));
    EXPECT_EQ(problemOf(R"({"1":{"model":"A","taxels":1,"f":null}})").kind, Problem::Kind::noValues);
    EXPECT_EQ(problemOf(R"({"1":{"model":"A","taxels":1}})").kind, Problem::Kind::noValues);
    EXPECT_EQ(problemOf(R"({"1":{"f":[1,NaN,3]}})").kind, Problem::Kind::other);
    EXPECT_EQ(problemOf(R"({"1":{"f":[1,2,3]})").kind, Problem::Kind::other);
    EXPECT_EQ(decoder->counters().badValues, 6U);

    decoder->feed(bytesOf(R"({"t":2,"1":{"f":[1,2,3],"t":7,"note":"NaN \" Infinity"},"2":NaN})"));
    ASSERT_TRUE(decoder->next(frame)) << "model and number of taxels may be missing";
    EXPECT_EQ(frame.time_s, 2.0);
    EXPECT_EQ(decoder->problem(), Problem());
}

TEST(LineDecoder, dropsALineThatIsTooLongAndGoesOn) {
    const auto decoder = makeDecoder(CsvFormat{.lastColumn = 1}, Framing::stream);
    const std::string longLine(kLongestFrame + 10, '1');
    decoder->feed(bytesOf(longLine));
    DecodedFrame frame;
    EXPECT_FALSE(decoder->next(frame));
    EXPECT_EQ(decoder->pendingBytes(), 0U);
    decoder->feed(bytesOf("5\n7\n"));
    ASSERT_TRUE(decoder->next(frame));
    EXPECT_EQ(frame.values, std::vector<float>{7});
}

TEST(LineDecoder, survivesDeepJson) {
    const auto decoder = makeDecoder(JsonFormat{.values = "", .count = 1}, Framing::stream);
    EXPECT_EQ(decode(*decoder, std::string(100'000, '[') + "\n[3]\n"), (Frames{{3}}));
}

TEST(LineDecoder, takesADatagramForOneLine) {
    const auto decoder = makeDecoder(CsvFormat{.skip = 1, .lastColumn = 2}, Framing::datagrams);
    DecodedFrame frame;
    decoder->feed(bytesOf("1,2"));
    ASSERT_TRUE(decoder->next(frame)) << "no datagram is cut";
    EXPECT_EQ(frame.values, (std::vector<float>{1, 2}));
    decoder->feed(bytesOf("1,2\n3,4\n"));
    EXPECT_FALSE(decoder->next(frame));
}

} // namespace
} // namespace teleta::taxels
