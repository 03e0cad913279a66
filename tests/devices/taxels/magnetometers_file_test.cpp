// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/magnetometers_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

namespace teleta::taxels {
namespace {

const std::string kCross =
    "kind = 'magnetometers'\nname = 'skin'\npath = 'ttyACM0'\nchips = 5\nformat = 'binary'\n"
    "positions_mm = [[0, 0], [7, 0], [-7, 0], [0, 7], [0, -7]]\naxes = ['+x', '-y', '-z']\nthreshold_uT = "
    "40.0\n";

void put(std::vector<std::uint8_t>& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

TEST(MagnetometersFile, isADescribedArrayInMicrotesla) {
    const auto file = parseTaxels(kCross, "/files/skin.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->name, "skin");
    EXPECT_EQ(file->address, link::Address(link::SerialAddress{"/files/ttyACM0", 115200}));
    EXPECT_EQ(file->grid.unit(), "µT");
    EXPECT_EQ(file->grid.layout().grid(), (core::ArrayLayout{3, 3, 0.007}));
    EXPECT_TRUE(file->grid.layout().isVector());
    EXPECT_TRUE(file->grid.layout().isAbsent(0));
    EXPECT_EQ(file->touchedFrom(), 40.0);
    EXPECT_EQ(file->restFrames, 50);
    EXPECT_EQ(std::get<BinaryFormat>(file->format).length, 82U) << "16 bytes a chip and the end";
}

TEST(MagnetometersFile, saysWhatIsWrongWhere) {
    struct Case {
        std::string text;
        std::string with;
        std::string words;
        long long line;
    };
    const std::vector<Case> cases{
        {"chips = 5", "chips = 65", "64", 4},
        {"chips = 5", "chips = 4", "a list of 4 lists", 6},
        {"'binary'", "'text'", "reskin_text", 5},
        {"[0, -7]]", "[0, 7]]", "taxels 3 and 4 are at the same place", 6},
        {"'-z'", "'z'", "not three distinct axes", 7},
        {"threshold_uT = 40.0\n", "", "threshold_uT", 0},
        {"'magnetometers'", "'magnetometer'", "taxels", 1},
    };
    for (const Case& known : cases) {
        std::string text = kCross;
        text.replace(text.find(known.text), known.text.size(), known.with);
        const auto file = parseTaxels(text, "skin.toml");
        ASSERT_FALSE(file) << known.with;
        EXPECT_NE(core::describe(file.error()).find(known.words), std::string::npos)
            << core::describe(file.error());
        EXPECT_EQ(file.error().where.line, known.line) << core::describe(file.error());
    }
}

TEST(MagnetometersFile, knowsTheNumberOfChipsByTheEndsOfTheFrames) {
    for (const int chips : {4, 5, 16, 64}) {
        std::vector<std::uint8_t> bytes{0x0D, 0x0A, 0x00};
        for (int frame = 0; frame < 4; ++frame) {
            for (int chip = 0; chip < chips; ++chip)
                for (const float value :
                     {24.5F, 10.0F * static_cast<float>(chip), -3.0F, static_cast<float>(frame)})
                    put(bytes, value);
            bytes.push_back(0x0D);
            bytes.push_back(0x0A);
        }
        EXPECT_EQ(chipsOf(bytes), chips);
    }
    EXPECT_EQ(chipsOf({}), std::nullopt);
    EXPECT_EQ(chipsOf(std::vector<std::uint8_t>(4096, 0x0D)), std::nullopt);
}

} // namespace
} // namespace teleta::taxels
