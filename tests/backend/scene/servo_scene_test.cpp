// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace teleta::scene {
namespace {

std::string straightBar() {
    std::ostringstream text;
    text << std::ifstream(TELETA_SOURCE_DIR "/resources/scenes/servo-straight-bar.toml").rdbuf();
    return text.str();
}

/// The scene with one text put in the place of another, and the line that this stands in.
core::Expected<Scene> changed(const std::string& from, const std::string& to, int* line = nullptr) {
    std::string text = straightBar();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (line != nullptr)
        *line = 1 + static_cast<int>(
                        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    return parseScene(text.replace(at, from.size(), to), "servo.toml");
}

Scene valid() {
    auto scene = parseScene(straightBar(), "servo.toml");
    EXPECT_TRUE(scene) << describe(scene.error());
    return scene ? *scene : Scene();
}

} // namespace

TEST(ServoScene, isReadWithItsArmSensorObjectAndTask) {
    const Scene scene = valid();
    ASSERT_TRUE(scene.isServo());
    EXPECT_EQ(scene.servo().arm.start_rad[3], -1.4);
    EXPECT_EQ(scene.taxels().columns, 14);
    EXPECT_EQ(scene.servo().sensor.images_Hz, 140.0);
    EXPECT_EQ(std::get<BarShape>(scene.servo().object.shape).radius_m, 0.003);
    EXPECT_EQ(scene.servo().task.kind, ServoTaskKind::exploreEdge);
    EXPECT_TRUE(scene.servo().task.moment);
    EXPECT_TRUE(checkServoScene(scene));
    EXPECT_FALSE(checkArmScene(scene));
    EXPECT_FALSE(checkArrayScene(scene));
}

TEST(ServoScene, saysInWhichLineSomethingIsWrong) {
    struct Fault {
        const char* from;
        const char* to;
    };
    for (const Fault& fault :
         {Fault{"a4 = -1.4", "a4 = -2.4"}, Fault{"shape = \"bar\"", "shape = \"rod\""},
          Fault{"stiffness_N_per_m = 1e7", "stiffness_N_per_m = 1e10"},
          Fault{"force_N = 10.0", "force_N = 31.0"}, Fault{"force_N = 10.0", "force = 10.0"},
          Fault{"kind = \"explore_edge\"\nforce_N = 10.0\napproach_m_per_s = 0.006\nslide_m_per_s = 0.005",
                "kind = \"comanipulate\"\nforce_N = 10.0\napproach_m_per_s = 0.006"},
          Fault{"name = \"crosstalk\"", "name = \"torque_noise\""},
          Fault{"yaw_rad = 0.087", "yaw_rad = -0.087"}}) {
        int line = 0;
        const auto scene = changed(fault.from, fault.to, &line);
        ASSERT_FALSE(scene) << fault.to;
        EXPECT_EQ(scene.error().where.line, line) << fault.to << ": " << describe(scene.error());
        EXPECT_GT(scene.error().where.column, 0) << fault.to;
    }
}

TEST(ServoScene, aProgramsOwnSceneIsCheckedToo) {
    const auto broken = [](auto change) {
        Scene scene = valid();
        change(scene);
        return !checkScene(scene);
    };
    EXPECT_FALSE(broken([](Scene&) {}));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().arm.start_rad[1] = 3.0; }));
    EXPECT_TRUE(
        broken([](Scene& s) { s.servo().arm.dampingRatio = std::numeric_limits<double>::quiet_NaN(); }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().sensor.images_Hz = 0.0; }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().object.stiffness_NPerM = 1.0; }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().object.shape = BallShape{-0.1}; }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().task.force_N = 0.0; }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().task.kind = ServoTaskKind::comanipulate; }));
    EXPECT_TRUE(broken([](Scene& s) { s.servo().object.hinge = TrayHinge{.inertia_kgm2 = 1.0}; }));
    EXPECT_TRUE(broken([](Scene& s) { s.effects.push_back({"", HousingRimSpec{.stiffness_NPerM = -1.0}}); }));
    EXPECT_TRUE(broken([](Scene& s) { s.effects.push_back({"", GearRippleSpec{0.1, 10.0}}); }));
}

} // namespace teleta::scene
