// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace teleta::scene {

namespace {

const std::string kHead = R"(name = "N"
description = "D"
duration_s = 4.0
rate_Hz = 1000
)";
const std::string kArm = R"([arm]
start_rad = { roll = 0.1, pitch = -0.2, yaw = 0.3, elbow = 1.0 }
[arm.control]
kind = "position"
bandwidth_rad_per_s = 50
)";
const std::string kSkin = R"([skin]
rows = 20
columns = 24
pitch_m = 0.0094
rate_Hz = 200
centre_distance_m = 0.14
full_scale_N = 2.0
)";
const std::string kProgram = R"([program]
kind = "contour"
directions = 24
approach_m_per_s = 0.004
travel_m_per_s = 0.1
clearance_m = 0.004
retract_m = 0.02
torque_limit_Nm = 0.08
hold_s = 0.1
)";
const std::string kObject = R"([[object]]
name = "disc"
shape = "round"
radius_m = 0.04
x_m = 0.2
y_m = 0.01
z_m = -0.3
stiffness_N_per_m = 8562.9
)";

std::string errorOf(const std::string& text) {
    const auto scene = parseScene(text, "s.toml");
    return scene ? std::string("no error") : describe(scene.error());
}

} // namespace

TEST(ArmScene, isReadWithItsUnits) {
    const auto scene = parseScene(kHead + kArm + kSkin + kProgram + kObject +
                                      "[[effects]]\nname = \"torque_noise\"\nwhy = \"w\"\nsd_Nm = 0.0005\n" +
                                      "[[effects]]\nname = \"dead_taxels\"\nwhy = \"w\"\n"
                                      "taxels = [{ row = 19, column = 23 }]\n",
                                  "s.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    ASSERT_TRUE(scene->isArm());
    const ArmWorld& world = scene->arm();
    EXPECT_EQ(world.body.start_rad, (core::JointVector{0.1, -0.2, 0.3, 1.0}));
    // k_ri P_C^2 with the paper's k_ri = 3468.6 N/m at P_C = 0.175 m.
    EXPECT_NEAR(world.body.jointStiffness_NmPerRad[3], 106.2259, 1e-4);
    EXPECT_EQ(std::get<PositionControl>(world.control).bandwidth_radPerS, 50.0);
    EXPECT_EQ(world.skin.layout, (core::ArrayLayout{20, 24, 0.0094}));
    EXPECT_EQ(scene->taxels(), world.skin.layout);
    EXPECT_EQ(std::get<ContourProgram>(world.program).directions, 24);
    ASSERT_EQ(world.objects.size(), 1U);
    EXPECT_EQ(std::get<RoundOutline>(world.objects[0].outline).radius_m, 0.04);
    EXPECT_EQ(world.objects[0].stiffness_NPerM, 8562.9);
    ASSERT_EQ(scene->effects.size(), 2U);
    EXPECT_EQ(nameOf(scene->effects[0]), "torque_noise");
    EXPECT_TRUE(checkArmScene(*scene));
    EXPECT_FALSE(checkArrayScene(*scene));
}

TEST(ArmScene, placesWhatIsWrong) {
    EXPECT_EQ(
        errorOf(kHead + kArm + kSkin + kProgram + kObject + "radus_m = 1\n"),
        "s.toml:34:1: unknown key \"radus_m\"; perhaps \"radius_m\" is meant (expected one of: name, shape, "
        "radius_m, x_m, y_m, z_m, angle_rad, stiffness_N_per_m)");
    EXPECT_EQ(errorOf(kHead + kArm + kSkin + kProgram),
              "s.toml:18:8: the program has no object to touch (expected at least one [[object]])");
    EXPECT_EQ(
        errorOf(kHead +
                "[arm]\nstart_rad = { roll = 0, pitch = 0, yaw = 0, elbow = 3.0 }\n"
                "control = { kind = \"position\", bandwidth_rad_per_s = 50 }\n" +
                kSkin + kProgram + kObject),
        "s.toml:6:13: the arm starts outside the range of its joints (expected elbow from -0.2 to 2.6)");
    EXPECT_EQ(
        errorOf(kHead +
                "[arm]\nstart_rad = { roll = 0, pitch = 0, yaw = 0, elbow = 1 }\n"
                "control = { kind = \"positon\", bandwidth_rad_per_s = 50 }\n" +
                kSkin + kProgram + kObject),
        "s.toml:7:20: unknown value \"positon\" of \"kind\"; perhaps \"position\" is meant (expected one of: "
        "position, admittance)");
    EXPECT_EQ(errorOf(kHead + kArm + kSkin + kProgram + "stiffness = 1\n" + kObject),
              "s.toml:26:1: unknown key \"stiffness\" (expected one of: kind, directions, start_angle_rad, "
              "approach_m_per_s, travel_m_per_s, clearance_m, retract_m, torque_limit_Nm, hold_s)");
    EXPECT_EQ(errorOf(kHead + kArm + kProgram + kObject), "s.toml: \"skin\" is missing");
}

TEST(ArmScene, readsAnOperatorHisLinkAndWhatHeDoesNotKnow) {
    const std::string program =
        "[program]\nkind = \"operator\"\ntravel_m_per_s = 0.06\napproach_m_per_s = 0.004\n"
        "clearance_m = 0.015\nfelt_torque_Nm = 0.15\nreaction_s = 0.2\nhold_s = 0.1\n"
        "explore = [{ x_m = 0.1, y_m = 0.2, radius_m = 0.08, touches = 10 }]\n";
    const std::string unknown = "[unknown]\nswap = true\nspread_m = 0.006\nturn_rad = 1.5\n";
    const std::string link =
        "[[effects]]\nname = \"link_delay\"\nwhy = \"w\"\ndelay_s = 0.02\njitter_s = 0.01\n"
        "loss_share = 0.1\noutage_at_s = 2\noutage_s = 0.5\n";
    const auto scene = parseScene(kHead + kArm + kSkin + program + unknown + kObject + link, "s.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_TRUE(scene->isTeleoperated());
    const auto& operates = std::get<OperatorProgram>(scene->arm().program);
    EXPECT_EQ(operates.reaction_s, 0.2);
    ASSERT_EQ(operates.explorations.size(), 1U);
    EXPECT_EQ(operates.explorations[0].touches, 10);
    EXPECT_TRUE(scene->arm().unknown.swap);
    EXPECT_EQ(scene->arm().unknown.turn_rad, 1.5);
    const auto* spec = scene->listed<LinkDelaySpec>();
    ASSERT_NE(spec, nullptr);
    EXPECT_EQ(spec->delay_s, 0.02);
    EXPECT_EQ(spec->jitter_s, 0.01);
    EXPECT_EQ(spec->lossShare, 0.1);
    EXPECT_EQ(spec->outageAt_s, 2.0);
    EXPECT_EQ(spec->outage_s, 0.5);
    EXPECT_EQ(nameOf(scene->effects[0]), "link_delay");

    EXPECT_EQ(
        errorOf(kHead + kArm + kSkin + kProgram + kObject + link),
        "s.toml:35:8: unknown value \"link_delay\" of \"name\" (expected one of: crosstalk, hysteresis, "
        "nonlinear_response, gain_spread, drift, noise, saturation, quantization, dead_taxels, latency, "
        "gravity_error, gear_ripple, torque_noise, encoder_quantization, nonlinear_object)");
    Scene copy = *scene;
    copy.arm().program = YieldProgram{};
    EXPECT_FALSE(checkScene(copy)); // nobody is at the other end of the link
    copy = *scene;
    copy.arm().unknown.spread_m = -0.1;
    EXPECT_FALSE(checkScene(copy));
    copy = *scene;
    std::get<OperatorProgram>(copy.arm().program).explorations.clear();
    EXPECT_FALSE(checkScene(copy));
}

TEST(ArmScene, aloneHasTheEffectsOfAnArm) {
    const std::string array = R"([sensor]
kind = "array"
rows = 6
columns = 14
pitch_m = 0.0034
stiffness_N_per_m = 1200
full_scale_N = 2.89
[[indenter]]
name = "ball"
shape = "sphere"
radius_m = 0.01
keyframes = [{ time_s = 0, depth_m = 0 }]
[[effects]]
name = "torque_noise"
why = "w"
)";
    EXPECT_EQ(
        errorOf(kHead + array),
        "s.toml:18:8: unknown value \"torque_noise\" of \"name\" (expected one of: crosstalk, hysteresis, "
        "nonlinear_response, gain_spread, drift, noise, saturation, quantization, dead_taxels, latency)");
}

TEST(CheckScene, refusesAnArmThatNoFileCouldDescribe) {
    const auto valid = parseScene(kHead + kArm + kSkin + kProgram + kObject, "s.toml");
    ASSERT_TRUE(valid) << describe(valid.error());
    const auto broken = [&](auto change) {
        Scene copy = *valid;
        change(copy.arm());
        return !checkScene(copy);
    };
    const double nan = std::nan("");
    EXPECT_FALSE(broken([](ArmWorld&) {}));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.body.forearmMass_kg = 0.0; }));
    EXPECT_TRUE(broken([&](ArmWorld& w) { w.body.start_rad[2] = nan; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.body.jointStiffness_NmPerRad[0] = 0.0; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.control = PositionControl{0.0}; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.control = AdmittanceControl{-1.0, 0.0, 1.0}; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.skin.layout.rows = 0; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.skin.rate_Hz = 0.0; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.objects[0].stiffness_NPerM = 0.0; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.objects[0].outline = TriangleOutline{}; }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.objects.clear(); }));
    EXPECT_TRUE(broken([](ArmWorld& w) { w.program = ContourProgram{.directions = 2}; }));
    EXPECT_TRUE(broken([](ArmWorld& w) {
        w.program = YieldProgram{.waypoints = {Waypoint{1.0, {}}, Waypoint{1.0, {}}}};
    }));
}

} // namespace teleta::scene
