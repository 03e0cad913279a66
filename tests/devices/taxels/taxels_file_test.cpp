// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/taxels/taxel_files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::taxels {
namespace {

using test::kGrid;

/// The example of the specification, in one line each.
const std::string kGlove =
    "kind = 'taxels'\nname = 'glove'\n[link]\ntype = 'serial'\npath = 'ttyUSB0'\nbaud = 921600\nparity = "
    "'even'\n"
    "stop_bits = 2\ngreeting = \"s\\n\"\ngoodbye = \"x\\n\"\n[frame]\nencoding = 'binary'\nsync = 'AA 55'\n"
    "length = 179\nchecksum = { type = 'crc16-ccitt', at = -2, from = 2, to = -2, order = 'little', init = "
    "0xFFFF, xor = 0 }\ncounter = { at = 4, type = 'uint8' }\ntime = { at = 5, type = 'uint32', unit = 'us' "
    "}\n"
    "values = { at = 9, type = 'uint16', order = 'little', count = 84, scale = 0.001, offset = 0.0 "
    "}\n[layout]\n"
    "rows = 6\ncolumns = 14\npitch_x_mm = 3.4\npitch_y_mm = 3.4\norder = 'row'\nunit = 'N'\n";

TEST(TaxelsFile, readsADescription) {
    const TaxelsFile file = test::parsed(kGlove);
    EXPECT_EQ(file.name, "glove");
    EXPECT_EQ(file.address,
              link::Address(link::SerialAddress{"/files/ttyUSB0", 921600, link::Parity::even, 2}));
    EXPECT_EQ(file.greeting, "s\n");
    EXPECT_EQ(file.goodbye, "x\n");
    EXPECT_EQ(file.grid.layout(), (core::ArrayLayout{6, 14, 0.0034}));
    EXPECT_EQ(file.grid.unit(), "N");
    EXPECT_EQ(file.touchedFrom(), 0.2);
    const auto& format = std::get<BinaryFormat>(file.format);
    EXPECT_EQ(format.sync, (std::vector<std::uint8_t>{0xAA, 0x55}));
    EXPECT_EQ(format.length, 179U);
    EXPECT_EQ(format.checksum.type, ChecksumType::crc16Ccitt);
    EXPECT_EQ(format.checksum.from, 2);
    EXPECT_EQ(format.time->unit_s, 1e-6);
    EXPECT_EQ(format.values.count, 84U);
    EXPECT_EQ(format.scaling.scale, 0.001);
}

TEST(TaxelsFile, hasTheUsualChecksumBeforeTheClosingBytesWhenNothingElseIsSaid) {
    const TaxelsFile file = test::parsed(
        test::head() + test::serialLink("/dev/ttyACM0") + kGrid +
        "[frame]\nencoding = 'binary'\nend = '0D0A'\nlength = 90\nchecksum = { type = 'crc32' }\n"
        "values = { at = 0, type = 'uint8', count = 84 }\n");
    const ChecksumField& checksum = std::get<BinaryFormat>(file.format).checksum;
    EXPECT_EQ(checksum.at, -6);
    EXPECT_EQ(checksum.from, 0);
    EXPECT_EQ(checksum.to, -6);
    EXPECT_EQ(checksum.init, 0xFFFF'FFFFU);
    EXPECT_EQ(checksum.xorOut, 0xFFFF'FFFFU);
}

TEST(TaxelsFile, readsTheOtherLinks) {
    const auto linked = [](const std::string& link) {
        return test::parsed(test::head() + "[link]\n" + link + kGrid + test::kCsv).address;
    };
    EXPECT_EQ(linked("type = 'tcp'\nhost = 'hand'\nport = 4000\n"),
              link::Address(link::TcpAddress{"hand", 4000}));
    EXPECT_EQ(linked("type = 'udp'\nport = 4000\n"), link::Address(link::UdpAddress{4000, ""}));
    EXPECT_EQ(linked("type = 'udp'\nport = 4000\nfrom = '10.0.0.2'\n"),
              link::Address(link::UdpAddress{4000, "10.0.0.2"}));
    EXPECT_EQ(linked("type = 'websocket'\nurl = 'ws://hand:4000/a'\n"),
              link::Address(link::WebAddress{"ws://hand:4000/a"}));
    EXPECT_EQ(linked("type = 'file'\npath = 'bytes.bin'\n"),
              link::Address(link::FileAddress{"/files/bytes.bin"}));
}

TEST(TaxelsFile, takesWhatIsSentAsTextOrBytes) {
    const std::string link = test::serialLink("/dev/ttyACM0");
    const auto file = test::parsed(test::head() + link + "greeting_bytes = 'AA 00'\n" + kGrid + test::kCsv);
    EXPECT_EQ(file.greeting, std::string("\xAA\x00", 2));
    const auto both =
        parseTaxels(test::head() + link + "greeting = 'a'\ngreeting_bytes = 'AA 00'\n" + kGrid + test::kCsv,
                    "glove.toml");
    ASSERT_FALSE(both);
    EXPECT_EQ(both.error().where.line, 8);
}

TEST(TaxelsFile, saysWhatIsWrongWhere) {
    struct Case {
        std::string text;
        std::string with;
        std::string words;
        long long line;
    };
    const std::vector<Case> cases{
        {"kind = 'taxels'", "kind = 'taxel'", "magnetometers", 1},
        {"name = 'glove'", "nam = 'glove'", "nam", 2},
        {"type = 'serial'", "type = 'usb'", "usb", 4},
        {"baud = 921600", "baud = 1", "9600", 6},
        {"stop_bits = 2", "stop_bits = 3", "3", 8},
        {"encoding = 'binary'", "encoding = 'hex'", "hex", 12},
        {"sync = 'AA 55'", "sync = 'AA 5'", "not a list of hexadecimal bytes", 13},
        {"sync = 'AA 55'", "sync = 'XY'", "not a list of hexadecimal bytes", 13},
        {"length = 179", "", "the length of a frame is not clear", 11},
        {"length = 179", "length = 1", "longer than the frame", 14},
        {"length = 179", "length = 100", "are not in the frame", 18},
        {"length = 179", "length_field = { at = 2, type = 'float32', counts = 'frame' }", "float32", 14},
        {"length = 179", "length_field = { at = 2, type = 'uint8', counts = 'words' }", "words", 14},
        {"at = -2, from = 2", "at = 178, from = 2", "are not in the frame", 15},
        {"to = -2", "to = -1", "covers itself", 15},
        {"from = 2, to = -2", "from = 9, to = 9", "covers no byte", 15},
        {"from = 2, to = -2", "from = 2, to = -200", "covers no byte", 15},
        {"init = 0xFFFF", "init = -1", "0", 15},
        {"at = 4, type = 'uint8'", "at = 179, type = 'uint8'", "not in the frame", 16},
        {"at = 4, type = 'uint8'", "at = 4, type = 'int8'", "int8", 16},
        {"unit = 'us'", "unit = 'min'", "min", 17},
        {"at = 5, type = 'uint32'", "at = -3, type = 'uint32'", "not in the frame", 17},
        {"count = 84", "count = 83", "83 numbers, but the layout has 84 taxels", 12},
        {"count = 84", "count = 84, stride = 1", "more bytes than that", 18},
        {"count = 84", "count = 84, stride = 3", "not in the frame", 18},
        {"scale = 0.001", "scale = 0", "a factor of 0", 18},
        {"unit = 'N'", "unit = 'counts'", "not known which taxels are touched", 0},
        {"rows = 6", "rows = 1025", "1024", 20},
    };
    for (const Case& known : cases) {
        std::string text = kGlove;
        const std::size_t at = text.find(known.text);
        ASSERT_NE(at, std::string::npos) << known.text;
        text.replace(at, known.text.size(), known.with);
        const auto file = parseTaxels(text, "glove.toml");
        ASSERT_FALSE(file) << known.with;
        EXPECT_NE(core::describe(file.error()).find(known.words), std::string::npos)
            << known.with << ": " << core::describe(file.error());
        EXPECT_EQ(file.error().where.line, known.line) << known.with << ": " << core::describe(file.error());
        EXPECT_EQ(file.error().where.column > 0, known.line > 0) << core::describe(file.error());
    }
}

TEST(TaxelsFile, knowsTheKindsOfArrays) {
    for (const char* kind : {"taxels", "magnetometers", "xela"})
        EXPECT_TRUE(isArrayKind(kind));
    EXPECT_FALSE(isArrayKind("wts"));
    EXPECT_FALSE(isArrayKind(""));
    EXPECT_NE(core::describe(parseTaxels("name = 'glove'\n", "glove.toml").error()).find("kind"),
              std::string::npos);
}

TEST(TaxelsFile, saysWhatIsWrongWithTextFrames) {
    struct Case {
        std::string frame;
        std::string words;
    };
    const std::vector<Case> cases{
        {"encoding = 'csv'\ncolumns = '85..2'", "names no columns"},
        {"encoding = 'csv'\ncolumns = '0..84'", "names no columns"},
        {"encoding = 'csv'\ncolumns = '2-85'", "names no columns"},
        {"encoding = 'csv'\ncolumns = '2..84'", "83 numbers"},
        {"encoding = 'csv'\ncolumns = '2..85'\ntime_column = 3", "cannot be a value and the time"},
        {"encoding = 'csv'\ncolumns = '2..85'\nseparator = ', '", "cannot separate numbers"},
        {"encoding = 'csv'\ncolumns = '2..85'\nseparator = '.'", "cannot separate numbers"},
        {"encoding = 'json'\nvalues = 'data'\ncount = 84", "no JSON pointer"},
        {"encoding = 'json'\nvalues = '/a~2'\ncount = 84", "no JSON pointer"},
        {"encoding = 'json'\nvalues = '/data'\ncount = 85", "85 numbers"},
        {"encoding = 'binary'\nlength = 84\nvalues = { at = 0, type = 'uint8', count = 84 }",
         "nothing shows where a frame begins"},
    };
    for (const Case& known : cases) {
        const auto file = parseTaxels(test::head() + test::serialLink("/dev/ttyUSB0") + kGrid + "[frame]\n" +
                                          known.frame + '\n',
                                      "glove.toml");
        ASSERT_FALSE(file) << known.frame;
        EXPECT_NE(core::describe(file.error()).find(known.words), std::string::npos)
            << core::describe(file.error());
        EXPECT_GE(file.error().where.line, 12) << core::describe(file.error());
    }
}

} // namespace
} // namespace teleta::taxels
