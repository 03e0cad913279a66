// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace teleta;
using scene::parseScene;

namespace {

const std::string kHead = R"(name = "N"
description = "D"
duration_s = 4
rate_Hz = 200
)";
const std::string kSensor = R"([sensor]
kind = "array"
rows = 6
columns = 14
pitch_m = 0.0034
stiffness_N_per_m = 1200
full_scale_N = 2.89
)";
const std::string kIndenter = R"([[indenter]]
name = "ball"
shape = "sphere"
radius_m = 0.01
keyframes = [{ time_s = 0, depth_m = 0.001 }]
)";

std::string errorOf(const std::string& text) {
    const auto scene = parseScene(text, "s.toml");
    return scene ? std::string() : describe(scene.error());
}

std::string withIndenter(const std::string& lines) {
    return kHead + kSensor + "[[indenter]]\nname = \"i\"\n" + lines;
}

std::string withEffect(const std::string& lines) {
    return kHead + kSensor + kIndenter + "[[effects]]\n" + lines;
}

} // namespace

TEST(SceneReader, readsEveryField) {
    const auto scene = parseScene(kHead + kSensor + "firing_threshold_N = 0.2\n" + kIndenter + R"([[indenter]]
name = "bar"
shape = "cylinder"
radius_m = 0.004
length_m = 0.03
loop = true
keyframes = [
  { time_s = 0.5, x_m = 0.001, y_m = -0.002, depth_m = -0.01, angle_rad = 0.3 },
  { time_s = 1.5, x_m = 0.002, depth_m = 0.001 },
  { time_s = 2.0, x_m = 0.001, y_m = -0.002, depth_m = -0.01, angle_rad = 3.4416 },
]
[[indenter]]
name = "edge"
shape = "box_edge"
length_m = 0.05
keyframes = [{ time_s = 0, depth_m = 0 }]
[[indenter]]
name = "punch"
shape = "flat_punch"
length_m = 0.02
width_m = 0.01
keyframes = [{ time_s = 0, depth_m = 0 }]
[[effects]]
name = "noise"
why = "w"
sd_N = 0.01
[[effects]]
name = "dead_taxels"
why = "w2"
taxels = [{ row = 5, column = 13 }]
reading_N = nan
[[effects]]
name = "drift"
why = "w3"
sd_N = 0.02
time_constant_s = 30
)",
                                  "s.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->name, "N");
    EXPECT_EQ(scene->description, "D");
    EXPECT_EQ(scene->duration_s, 4.0);
    EXPECT_EQ(scene->rate_Hz, 200.0);
    EXPECT_EQ(scene->array().sensor.layout, (core::ArrayLayout{6, 14, 0.0034}));
    EXPECT_EQ(scene->array().sensor.stiffness_NPerM, 1200.0);
    EXPECT_EQ(scene->array().sensor.fullScale_N, 2.89);
    EXPECT_EQ(scene->array().sensor.firingThreshold_N, 0.2);
    ASSERT_EQ(scene->array().indenters.size(), 4U);
    EXPECT_EQ(std::get<scene::Sphere>(scene->array().indenters[0].shape).radius_m, 0.01);
    EXPECT_FALSE(scene->array().indenters[0].loop);
    const scene::Indenter& bar = scene->array().indenters[1];
    EXPECT_EQ(bar.name, "bar");
    EXPECT_EQ(std::get<scene::Cylinder>(bar.shape).radius_m, 0.004);
    EXPECT_EQ(std::get<scene::Cylinder>(bar.shape).length_m, 0.03);
    EXPECT_TRUE(bar.loop);
    ASSERT_EQ(bar.keyframes.size(), 3U);
    EXPECT_EQ(bar.keyframes[0].time_s, 0.5);
    EXPECT_EQ(bar.keyframes[0].x_m, 0.001);
    EXPECT_EQ(bar.keyframes[0].y_m, -0.002);
    EXPECT_EQ(bar.keyframes[0].depth_m, -0.01);
    EXPECT_EQ(bar.keyframes[0].angle_rad, 0.3);
    EXPECT_EQ(bar.keyframes[1].y_m, 0.0);
    EXPECT_EQ(std::get<scene::BoxEdge>(scene->array().indenters[2].shape).length_m, 0.05);
    EXPECT_EQ(std::get<scene::FlatPunch>(scene->array().indenters[3].shape).width_m, 0.01);
    ASSERT_EQ(scene->effects.size(), 3U);
    EXPECT_EQ(nameOf(scene->effects[0]), "noise");
    EXPECT_EQ(scene->effects[0].why, "w");
    const auto& dead = std::get<scene::DeadTaxelsSpec>(scene->effects[1].parameters);
    ASSERT_EQ(dead.taxels.size(), 1U);
    EXPECT_EQ(dead.taxels[0].row, 5);
    EXPECT_EQ(dead.taxels[0].column, 13);
    EXPECT_TRUE(std::isnan(dead.reading_N));
    EXPECT_EQ(std::get<scene::DriftSpec>(scene->effects[2].parameters).timeConstant_s, 30.0);
    EXPECT_TRUE(checkScene(*scene));
}

TEST(SceneReader, placesWhatIsWrongInTheSensor) {
    EXPECT_EQ(
        errorOf(kHead + "[sensr]\n" + kIndenter +
                "[[effects]]\nname = \"dead_taxels\"\nwhy = \"w\"\n"
                "taxels = [{ row = 3, column = 3 }]\n"),
        "s.toml:5:2: unknown key \"sensr\"; perhaps \"sensor\" is meant (expected one of: name, description, "
        "duration_s, rate_Hz, arm, robot, camera, gel, sensor, indenter, effects)");
    EXPECT_EQ(errorOf(kHead + kSensor + "pitch = 1\n" + kIndenter),
              "s.toml:12:1: \"pitch\" has no unit in its name (expected pitch_m)");
    EXPECT_EQ(errorOf(kHead + "[sensor]\nkind = \"aray\"\n" + kIndenter),
              "s.toml:6:8: unknown value \"aray\" of \"kind\"; perhaps \"array\" is meant (expected one of: "
              "array)");
    EXPECT_EQ(errorOf(kHead + "[sensor]\nkind = \"array\"\nrows = 1025\n" + kIndenter),
              "s.toml:7:8: \"rows\" is out of range: 1025 (expected a whole number from 1 to 1024)");
}

TEST(SceneReader, placesWhatIsWrongInAnIndenter) {
    EXPECT_EQ(errorOf(kHead + kSensor), "s.toml: \"indenter\" is missing");
    EXPECT_EQ(
        errorOf(withIndenter("shape = \"spher\"\n")),
        "s.toml:14:9: unknown value \"spher\" of \"shape\"; perhaps \"sphere\" is meant (expected one of: "
        "sphere, cylinder, box_edge, flat_punch)");
    EXPECT_EQ(
        errorOf(withIndenter("shape = \"box_edge\"\nlength_m = 1\nradius_m = 1\n"
                             "keyframes = [{ time_s = 0, depth_m = 0 }]\n")),
        "s.toml:16:1: unknown key \"radius_m\" (expected one of: name, shape, length_m, loop, keyframes)");
    const std::string sphere = "shape = \"sphere\"\nradius_m = 1\n";
    EXPECT_EQ(errorOf(withIndenter(sphere)), "s.toml:12:1: \"keyframes\" is missing");
    EXPECT_EQ(errorOf(withIndenter(sphere + "keyframes = []\n")),
              "s.toml:16:13: \"keyframes\" has too few entries (expected at least 1)");
    EXPECT_EQ(errorOf(withIndenter(sphere + "keyframes = [{ time_s = 0, depth_m = 0 },\n"
                                            " { time_s = 0, depth_m = 0 }]\n")),
              "s.toml:17:13: the times of the keyframes do not increase (expected a time after 0 s)");
    EXPECT_EQ(
        errorOf(withIndenter(sphere + "keyframes = [{ time_s = 0, z_m = 0 }]\n")),
        "s.toml:16:28: unknown key \"z_m\"; perhaps \"x_m\" is meant (expected one of: time_s, x_m, y_m, "
        "depth_m, angle_rad)");
    EXPECT_EQ(
        errorOf(withIndenter(sphere + "loop = true\nkeyframes = [{ time_s = 0, depth_m = 0 },\n"
                                      " { time_s = 1, depth_m = 0.1 }]\n")),
        "s.toml:16:8: the motion does not end where it starts (expected a last keyframe like the first one)");
}

TEST(SceneReader, placesWhatIsWrongInAnEffect) {
    EXPECT_EQ(errorOf(withEffect("name = \"nosie\"\nwhy = \"w\"\n")),
              "s.toml:18:8: unknown value \"nosie\" of \"name\"; perhaps \"noise\" is meant (expected one "
              "of: crosstalk, hysteresis, nonlinear_response, gain_spread, drift, noise, saturation, "
              "quantization, dead_taxels, latency)");
    EXPECT_EQ(errorOf(withEffect("name = \"noise\"\nsd_N = 1\n")), "s.toml:17:1: \"why\" is missing");
    EXPECT_EQ(errorOf(withEffect("name = \"noise\"\nwhy = \"\"\nsd_N = 1\n")),
              "s.toml:19:7: \"why\" is empty (expected a text in quotes)");
    EXPECT_EQ(errorOf(withEffect("name = \"noise\"\nwhy = \"w\"\nsd = 1\n")),
              "s.toml:20:1: \"sd\" has no unit in its name (expected sd_N)");
    EXPECT_EQ(errorOf(withEffect("name = \"crosstalk\"\nwhy = \"w\"\nshare = 1.1\n")),
              "s.toml:20:9: \"share\" is out of range: 1.1 (expected a number from 0 to 1)");
    EXPECT_EQ(errorOf(withEffect("name = \"saturation\"\nwhy = \"w\"\n[[effects]]\nname = \"saturation\"\n"
                                 "why = \"w\"\n")),
              "s.toml:21:8: the effect is listed twice (expected each effect at most once)");
    const std::string dead = "name = \"dead_taxels\"\nwhy = \"w\"\n";
    EXPECT_EQ(errorOf(withEffect(dead + "taxels = [{ row = 6, column = 0 }]\n")),
              "s.toml:20:19: \"row\" is out of range: 6 (expected a whole number from 0 to 5)");
    EXPECT_EQ(errorOf(withEffect(dead)),
              "s.toml:17:1: which taxels are dead is not clear (expected either \"count\" or \"taxels\")");
    EXPECT_EQ(errorOf(withEffect(dead + "count = 85\n")),
              "s.toml:20:9: \"count\" is out of range: 85 (expected a whole number from 1 to 84)");
}

TEST(CheckScene, refusesWhatNoFileCouldSay) {
    const auto valid = parseScene(withEffect("name = \"dead_taxels\"\nwhy = \"w\"\ncount = 1\n"), "s.toml");
    ASSERT_TRUE(valid) << describe(valid.error());
    EXPECT_TRUE(checkScene(*valid));
    const auto broken = [&](auto change) {
        scene::Scene copy = *valid;
        change(copy);
        return !checkScene(copy);
    };
    EXPECT_TRUE(broken([](scene::Scene& s) { s.rate_Hz = 0.0; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.rate_Hz = std::nan(""); }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().sensor.layout.rows = 0; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().sensor.layout.columns = 1025; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().sensor.layout.pitchX_m = 0.0; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().sensor.stiffness_NPerM = -1.0; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().sensor.firingThreshold_N = -1.0; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().indenters[0].shape = scene::Sphere{0.0}; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().indenters[0].shape = scene::FlatPunch{0.1, -0.1}; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().indenters[0].keyframes.clear(); }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.array().indenters[0].keyframes[0].x_m = std::nan(""); }));
    EXPECT_TRUE(broken([](scene::Scene& s) {
        s.array().indenters[0].keyframes.push_back(s.array().indenters[0].keyframes[0]);
    }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.effects.push_back(s.effects[0]); }));
    EXPECT_TRUE(broken([](scene::Scene& s) {
        s.effects[0].parameters = scene::DeadTaxelsSpec{.taxels = {{.row = 0, .column = 14}}};
    }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.effects[0].parameters = scene::CrosstalkSpec{1.5}; }));
    EXPECT_TRUE(broken([](scene::Scene& s) { s.effects[0].parameters = scene::QuantizationSpec{0.0}; }));
}
