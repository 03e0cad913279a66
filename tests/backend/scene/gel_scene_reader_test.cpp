// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::scene {
namespace {

const std::string kGelHead = "name = \"a\"\ndescription = \"b\"\nduration_s = 1.0\nrate_Hz = 25.0\n";
const std::string kGel = "[gel]\nrows = 6\ncolumns = 7\npitch_m = 0.002\nbright = true\nnoise = 1.5\n";
const std::string kBall =
    "[[ball]]\nname = \"b\"\nx_m = 0.01\ny_m = 0.012\nradius_m = 0.01\nfriction = 0.5\n";

std::string frames(const std::string& second) {
    return "keyframes = [{ time_s = 0.0, depth_m = -0.001 }, " + second + "]\n";
}

void expectGelFault(const std::string& text, long long line, const std::string& word) {
    const auto scene = parseScene(text, "scene.toml");
    ASSERT_FALSE(scene) << text;
    EXPECT_EQ(scene.error().where.line, line) << describe(scene.error());
    EXPECT_NE(describe(scene.error()).find(word), std::string::npos) << describe(scene.error());
}

} // namespace

TEST(GelScene, isReadWithItsBalls) {
    const auto scene =
        parseScene(kGelHead + kGel + kBall +
                       frames("{ time_s = 0.5, depth_m = 0.001, drag_y_m = 0.0002, turn_rad = 0.1 }"),
                   "scene.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_TRUE(scene->isGel());
    EXPECT_TRUE(scene->isSeen());
    EXPECT_FALSE(scene->isCamera());
    EXPECT_EQ(scene->gel().sensor.columns, 7);
    EXPECT_TRUE(scene->gel().sensor.bright);
    EXPECT_EQ(scene->gel().balls.front().friction, 0.5);
    EXPECT_EQ(scene->gel().balls.front().keyframes[1].dragY_m, 0.0002);
    EXPECT_EQ(scene->gel().balls.front().keyframes[1].turn_rad, 0.1);
    EXPECT_TRUE(checkGelScene(*scene));
    EXPECT_FALSE(checkCameraScene(*scene));
    EXPECT_FALSE(checkArrayScene(*scene));
}

TEST(GelScene, saysWhereAndWhatIsWrong) {
    const std::string ball = kBall + frames("{ time_s = 0.5, depth_m = 0.001 }");
    expectGelFault(kGelHead + "[gel]\nmarker_diameter_m = 0.003\npitch_m = 0.002\n" + ball, 6,
                   "touch each other");
    expectGelFault(kGelHead + "[gel]\npitch_m = 0.02\n" + ball, 6, "do not fit");
    expectGelFault(kGelHead + kGel + kBall + frames("{ time_s = 0.5, depth_m = 0.02 }"), 17, "deeper");
    expectGelFault(kGelHead + kGel + kBall + frames("{ time_s = 0.0, depth_m = 0.001 }"), 17,
                   "do not increase");
    EXPECT_FALSE(parseScene(kGelHead + kGel, "scene.toml")); // no ball
    EXPECT_FALSE(parseScene(kGelHead + kGel + ball +
                                "[[effects]]\nname = \"sensor_noise\"\nwhy = \"w\"\nread = "
                                "1.0\nshot = 2.0\n",
                            "scene.toml"));
}

} // namespace teleta::scene
