// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::scene {
namespace {

const std::string kHead = "name = \"a\"\ndescription = \"b\"\nduration_s = 1.0\nrate_Hz = 40.0\n";
const std::string kCamera = "[camera]\nfocal_length_px = 500.0\n[skin]\nradius_m = 0.02\n";

void expectFault(const std::string& text, long long line, const std::string& word) {
    const auto scene = parseScene(text, "scene.toml");
    ASSERT_FALSE(scene) << text;
    EXPECT_EQ(scene.error().where.line, line) << describe(scene.error());
    EXPECT_NE(describe(scene.error()).find(word), std::string::npos) << describe(scene.error());
}

} // namespace

TEST(CameraScene, isReadWithItsReactionAndEffects) {
    const auto scene =
        parseScene(kHead + kCamera +
                       "[reaction]\nkind = \"bump\"\nspeed_m_per_s = 0.05\n"
                       "[[finger]]\nname = \"f\"\nradius_m = 0.01\n"
                       "keyframes = [{ time_s = 0.0, angle_rad = 1.0, z_m = 0.05, depth_m = 0.001 }]\n"
                       "[[effects]]\nname = \"sensor_noise\"\nwhy = \"w\"\nread = 1.0\nshot = 2.0\n",
                   "scene.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_TRUE(scene->isCamera());
    EXPECT_EQ(scene->camera().camera.width_px, 1640);
    EXPECT_EQ(scene->camera().skin.radius_m, 0.02);
    EXPECT_EQ(std::get<BumpReaction>(scene->camera().reaction).speed_mPerS, 0.05);
    EXPECT_EQ(scene->camera().fingers.front().keyframes.front().angle_rad, 1.0);
    EXPECT_EQ(nameOf(scene->effects.front()), "sensor_noise");
    EXPECT_TRUE(checkCameraScene(*scene));
    EXPECT_FALSE(checkArrayScene(*scene));
    EXPECT_FALSE(checkArmScene(*scene));
}

TEST(CameraScene, isReadWithThePersonWhoProbesIt) {
    const auto scene = parseScene(kHead + kCamera +
                                      "[probing]\nholes_around = 12\nholes_along = 4\nfirst_z_m = 0.01\n"
                                      "last_z_m = 0.09\ndepth_m = 0.001\nwrong_share = 0.1\n",
                                  "scene.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_TRUE(scene->camera().probing);
    EXPECT_EQ(scene->camera().probing->around, 12);
    EXPECT_EQ(scene->camera().probing->along, 4);
    EXPECT_EQ(scene->camera().probing->last_z_m, 0.09);
    EXPECT_EQ(scene->camera().probing->wrongShare, 0.1);
    EXPECT_TRUE(checkCameraScene(*scene));
    const auto without = parseScene(kHead + kCamera, "scene.toml");
    ASSERT_TRUE(without);
    EXPECT_FALSE(without->camera().probing);
}

TEST(CameraScene, saysWhereAndWhatIsWrong) {
    expectFault(kHead + kCamera +
                    "[probing]\nfirst_z_m = 0.0\nlast_z_m = 0.1\ndepth_m = 0.001\nwrong_share = 1.2\n",
                13, "wrong_share");
    expectFault(kHead + kCamera + "[probing]\nfirst_z_m = 0.0\nlast_z_m = 0.1\n", 9, "depth_m");
    expectFault(kHead + "[camera]\nfocal_length = 500.0\n[skin]\n", 6, "focal_length_px");
    expectFault(kHead + "[camera]\nwidth_px = 0\n[skin]\n", 6, "width_px");
    expectFault(kHead + "[camera]\n[skin]\ndot_diameter_m = 0.005\n", 7, "dots touch");
    expectFault(kHead + "[camera]\n[skin]\ndot_pitch_m = 0.03\n", 7, "too few or too many");
    expectFault(kHead + "[camera]\n[skin]\ndot_pitch_m = 0.0001\ndot_diameter_m = 0.00005\n", 7, "dots");
    expectFault(kHead + "[camera]\noffset_y_m = -0.013\n[skin]\n", 6, "axis");
    expectFault(kHead + kCamera +
                    "[probing]\nfirst_z_m = 0.0\nlast_z_m = 0.1\ndepth_m = 0.01\nwrong_share = 0.1\n",
                12, "deeper than");
    expectFault(kHead + kCamera +
                    "[[finger]]\nname = \"f\"\nradius_m = 0.01\n"
                    "keyframes = [{ time_s = 0.0, angle_rad = 1.0, z_m = 0.05, depth_m = 0.01 }]\n",
                12, "deeper than");
    expectFault(kHead + kCamera + "[[effects]]\nname = \"crosstalk\"\nwhy = \"w\"\n", 10, "crosstalk");
    expectFault(kHead + kCamera + "[[finger]]\nname = \"f\"\nradius_m = 0.01\nkeyframes = []\n", 12,
                "keyframes");
}

TEST(CameraScene, hasNoEffectOfTaxelsAndOthersNoneOfACamera) {
    Scene camera;
    camera.rate_Hz = 40.0;
    camera.world = CameraWorld{};
    EXPECT_TRUE(checkCameraScene(camera));
    camera.effects.push_back({"", NoiseSpec{.sd_N = 0.1}});
    EXPECT_FALSE(checkCameraScene(camera));
    camera.effects = {{"", VignettingSpec{.share = 2.0}}};
    EXPECT_FALSE(checkCameraScene(camera));
    camera.effects.clear();
    camera.camera().camera.focalLength_px = 0.0;
    EXPECT_FALSE(checkCameraScene(camera));
}

} // namespace teleta::scene
