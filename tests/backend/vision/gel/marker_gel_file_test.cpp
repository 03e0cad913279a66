// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_gel_file.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace teleta::vision {
namespace {

const std::string kWhole = R"(kind = "marker_gel"
name = "left finger"
source = "0"
crop = [10, 20, 320, 240]
flip_x = true
flip_y = true
rate_Hz = 25
channel = "green"
marker = "bright"
diameter_px = 9
grid = "rectangular"
rows = 8
columns = 10
[plane]
mm_per_px = 0.0634
[lens]
fx = 300.0
fy = 301.0
cx = 160.0
cy = 120.0
k1 = -0.1
k2 = 0.01
p1 = 0.001
p2 = 0.002
k3 = 0.003
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

struct Wrong {
    std::string from, to;
    int line;
};

} // namespace

TEST(MarkerGelFile, readsEachKey) {
    const auto file = parseMarkerGel(kWhole, "gel.toml");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->name, "left finger");
    EXPECT_EQ(file->source, "0");
    EXPECT_EQ(file->crop, (std::vector<double>{10, 20, 320, 240}));
    EXPECT_TRUE(file->flipX && file->flipY);
    EXPECT_EQ(file->rate_Hz, 25.0);
    EXPECT_EQ(file->channel, GelChannel::green);
    EXPECT_EQ(file->polarity, MarkerPolarity::bright);
    EXPECT_EQ(file->diameter_px, 9.0);
    EXPECT_EQ(file->grid, MarkerGrid::rectangular);
    EXPECT_EQ(file->rows, 8);
    EXPECT_EQ(file->columns, 10);
    EXPECT_EQ(file->plane.mmPerPx, 0.0634);
    ASSERT_TRUE(file->lens);
    EXPECT_EQ(file->lens->fy_px, 301.0);
    EXPECT_EQ(file->lens->k3, 0.003);
}

TEST(MarkerGelFile, needsOnlyKindGridAndScale) {
    const auto file =
        parseMarkerGel("kind = \"marker_gel\"\ngrid = \"free\"\n[plane]\npitch_mm = 2.0\n", "gel.toml");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->channel, GelChannel::grey);
    EXPECT_EQ(file->polarity, MarkerPolarity::dark);
    EXPECT_EQ(file->diameter_px, 0.0);
    EXPECT_EQ(file->plane.pitch_mm, 2.0);
    EXPECT_FALSE(file->lens);
}

TEST(MarkerGelFile, tellsLineAndColumnOfWhatIsWrong) {
    for (const Wrong& wrong :
         {Wrong{"\"marker_gel\"", "\"gel\"", 1}, Wrong{"channel = \"green\"", "channel = \"cyan\"", 8},
          Wrong{"marker = \"bright\"", "marker = 1", 9}, Wrong{"diameter_px = 9", "diameter_px = 1", 10},
          Wrong{"diameter_px = 9", "diameter_px = -1", 10},
          Wrong{"grid = \"rectangular\"", "grid = \"square\"", 11}, Wrong{"rows = 8", "rows = 1", 12},
          Wrong{"columns = 10", "colums = 10", 13}, Wrong{"320, 240", "320", 4},
          Wrong{"320, 240", "320.5, 240", 4}, Wrong{"320, 240", "8, 8", 4},
          Wrong{"mm_per_px = 0.0634", "mm_per_px = 0", 15},
          Wrong{"mm_per_px = 0.0634", "mm_per_px = 0.1\npitch_mm = 2", 15},
          Wrong{"mm_per_px = 0.0634", "homography = [1, 2, 3]", 15},
          Wrong{"mm_per_px = 0.0634", "homography = [0, 0, 0, 0, 0, 0, 0, 0, 1]", 15},
          Wrong{"fx = 300.0", "fx = 0.0", 17}, Wrong{"k1 = -0.1", "k9 = -0.1", 21}}) {
        const auto file = parseMarkerGel(replaced(kWhole, wrong.from, wrong.to), "gel.toml");
        ASSERT_FALSE(file) << wrong.to;
        EXPECT_EQ(file.error().kind, core::ErrorKind::badInput) << wrong.to;
        EXPECT_EQ(file.error().where.file, "gel.toml");
        EXPECT_EQ(file.error().where.line, wrong.line) << wrong.to << ": " << file.error().message;
        EXPECT_GT(file.error().where.column, 0) << wrong.to;
    }
}

TEST(MarkerGelFile, theExampleIsRead) {
    const auto file = readMarkerGel(TELETA_SOURCE_DIR "/resources/devices/marker-gel.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->width_px, 320);
    EXPECT_EQ(file->plane.mmPerPx, 0.0634);
}

TEST(MarkerGelFile, needsAScale) {
    const auto file = parseMarkerGel("kind = \"marker_gel\"\ngrid = \"free\"\n[plane]\n", "gel.toml");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().where.file, "gel.toml");
    EXPECT_FALSE(parseMarkerGel("kind = \"marker_gel\"\ngrid = \"free\"\n", "gel.toml"));
}

TEST(MarkerGelFile, isReadBackAsItWasWritten) {
    const std::array<std::string, 3> texts{
        kWhole,
        "kind = \"marker_gel\"\nname = \"a \\\"b\\\"\"\nsource = \"0\"\nwidth_px = 640\nheight_px = "
        "480\nmarker = \"bright\"\nflip_y = true\n"
        "grid = \"hexagonal\"\n[plane]\nhomography = [1e-4, 0, 0, 0, 1.25e-4, 0.001, 0, 0, 1]\n",
        "kind = \"marker_gel\"\ngrid = \"free\"\n[plane]\npitch_mm = 2.0\n[lens]\nfx = 300\nfy = 301.5\n"
        "cx = 160\ncy = 120\nk1 = -0.1\n"};
    for (const std::string& text : texts) {
        const auto first = parseMarkerGel(text, "gel.toml");
        ASSERT_TRUE(first) << text;
        const std::string written = markerGelText(*first);
        const auto second = parseMarkerGel(written, "gel.toml");
        ASSERT_TRUE(second) << core::describe(second.error()) << '\n' << written;
        EXPECT_EQ(markerGelText(*second), written);
        EXPECT_EQ(second->name, first->name);
        EXPECT_EQ(second->source, first->source);
        EXPECT_EQ(second->width_px, first->width_px);
        EXPECT_EQ(second->height_px, first->height_px);
        EXPECT_EQ(second->crop, first->crop);
        EXPECT_EQ(second->flipX, first->flipX);
        EXPECT_EQ(second->flipY, first->flipY);
        EXPECT_EQ(second->rate_Hz, first->rate_Hz);
        EXPECT_EQ(second->channel, first->channel);
        EXPECT_EQ(second->polarity, first->polarity);
        EXPECT_EQ(second->diameter_px, first->diameter_px);
        EXPECT_EQ(second->grid, first->grid);
        EXPECT_EQ(second->rows, first->rows);
        EXPECT_EQ(second->columns, first->columns);
        EXPECT_EQ(second->plane.mmPerPx, first->plane.mmPerPx);
        EXPECT_EQ(second->plane.homography, first->plane.homography);
        EXPECT_EQ(second->plane.pitch_mm, first->plane.pitch_mm);
        ASSERT_EQ(second->lens.has_value(), first->lens.has_value());
        if (first->lens) {
            EXPECT_EQ(second->lens->fy_px, first->lens->fy_px);
            EXPECT_EQ(second->lens->k1, first->lens->k1);
        }
    }
}

} // namespace teleta::vision
