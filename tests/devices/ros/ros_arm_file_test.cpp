// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/files/ros_arm_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::ros_arm {
namespace {

const std::string kShortest = "kind = \"ros_arm\"\nname = \"Arm\"\nbase_frame = \"base_link\"\n"
                              "tip_frame = \"tool0\"\ncontroller = \"/arm_controller\"\n";

/// What describe() says of the shortest file with these lines after it; empty when all is well.
std::string errorWith(const std::string& lines) {
    const auto file = parseRosArm(kShortest + lines, "arm.toml");
    return file ? "" : core::describe(file.error());
}

TEST(RosArmFile, theShortestFileHasTheDefaults) {
    const auto file = parseRosArm(kShortest, "arm.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->name, "Arm");
    EXPECT_EQ(file->description, "");
    EXPECT_EQ(file->jointStates, "/joint_states");
    EXPECT_EQ(file->commandTopic(), "/arm_controller/joint_trajectory");
    EXPECT_EQ(file->jointTimeout_s, 0.1);
    EXPECT_EQ(file->effortUnit, EffortUnit::none);
    EXPECT_FALSE(file->effortContainsGravity);
    EXPECT_EQ(file->domain, dds::DomainConfig());
    EXPECT_EQ(file->distribution, Distribution::jazzy);
    EXPECT_TRUE(file->announce);
    EXPECT_EQ(file->wireName("joint_1"), "joint_1");
    EXPECT_EQ(file->limits.speedScale, 0.25);
    EXPECT_EQ(file->limits.tipSpeed_mPerS, 0.1);
    EXPECT_FALSE(file->limits.box_m);
    EXPECT_FALSE(file->limits.forceStop_N);
    EXPECT_TRUE(file->limits.effortStop_Nm.empty());
}

TEST(RosArmFile, everyKeyIsRead) {
    const std::string path = TELETA_SOURCE_DIR "/tests/fuzz/seeds/ros_arm_file/left.toml";
    const auto file = readRosArm(path);
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->name, "Left arm");
    EXPECT_EQ(file->baseFrame, "base_link");
    EXPECT_EQ(file->tipFrame, "tool0");
    EXPECT_EQ(file->controller, "/joint_trajectory_controller");
    EXPECT_EQ(file->effortUnit, EffortUnit::newtonMetre);
    EXPECT_EQ(file->required, std::vector<std::string>{"pad"});
    EXPECT_EQ(file->meshPath, TELETA_SOURCE_DIR "/tests/fuzz/seeds/ros_arm_file/meshes");
    EXPECT_EQ(file->domain, (dds::DomainConfig{0, "lo", {"127.0.0.1"}}));
    EXPECT_EQ(file->wireName("left_joint_1"), "joint_1");
    EXPECT_EQ(file->limits.stopDeceleration_radPerS2, 6.0);
    EXPECT_EQ(file->limits.effortStop_Nm, core::JointVector(40, 40, 30, 30, 10, 10, 5));
    EXPECT_EQ(file->limits.forceStop_N, 30.0);
    ASSERT_TRUE(file->limits.box_m);
    EXPECT_EQ(file->limits.box_m->min(), Eigen::Vector3d(-0.8, -0.8, 0.0));
    EXPECT_EQ(file->limits.box_m->max(), Eigen::Vector3d(0.8, 0.8, 1.2));
}

TEST(RosArmFile, pathsCountFromTheFileAndThePrefixGoesFirst) {
    const auto file = parseRosArm(kShortest + "description = \"left.urdf\"\nprefix = \"left_\"\n"
                                              "[joint_names]\nshoulder = \"j1\"\n",
                                  "/robots/arm.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->description, "/robots/left.urdf");
    EXPECT_EQ(file->wireName("shoulder"), "left_j1");
    EXPECT_EQ(file->wireName("elbow"), "left_elbow");
}

TEST(RosArmFile, saysWhereItIsWrong) {
    EXPECT_EQ(errorWith("speed = 1\n").substr(0, 33), "arm.toml:6:1: unknown key \"speed\"");
    EXPECT_EQ(errorWith("joint_timeout_s = 0.001\n"),
              "arm.toml:6:19: \"joint_timeout_s\" is out of range: 0.001 (expected a number from 0.02 to 1)");
    EXPECT_EQ(errorWith("[limits]\nspeed_scale = \"fast\"\n"),
              "arm.toml:7:15: wrong type for \"speed_scale\" (expected a number above 0, at most 1)");
    EXPECT_EQ(errorWith("[ros]\ndomain = 233\n"),
              "arm.toml:7:10: \"domain\" is out of range: 233 (expected a whole number from 0 to 232)");
    EXPECT_EQ(errorWith("[ros]\npeers = \"robot\"\n"),
              "arm.toml:7:9: wrong type for \"peers\" (expected a list of texts in quotes)");
    EXPECT_EQ(errorWith("[joint_names]\na = \"x\"\nb = \"x\"\n"),
              "arm.toml:8:5: two joints have the ROS name \"x\" (expected a unique name for each joint)");
    EXPECT_EQ(errorWith("joint_states = \"joint states\"\n"),
              "arm.toml:6:16: \"joint states\" is not a topic name (expected parts of letters, digits and _ "
              "after slashes, for example /joint_states)");
    EXPECT_EQ(
        errorWith("[limits]\nbox_m = [[0, 1], [1, 1], [0, 1]]\n"),
        "arm.toml:7:9: a side of the box is empty or reversed (expected [lowest, highest] for x, y and z)");
    EXPECT_EQ(parseRosArm("kind = \"ros_arm\"\n", "arm.toml").error().message, "\"name\" is missing");
}

TEST(RosArmFile, whatCannotBeKeptIsRefused) {
    EXPECT_EQ(errorWith("adapter = \"effort\"\n"),
              "arm.toml:6:11: unknown value \"effort\" of \"adapter\" (expected one of: trajectory, "
              "moveit_servo, velocity, position)");
    for (const char* adapter : {"velocity", "position"})
        EXPECT_EQ(errorWith(std::string("adapter = \"") + adapter + "\"\n"),
                  "arm.toml:6:11: with this adapter nothing stops the robot when this program ends or the "
                  "network fails "
                  "(expected another adapter, or unguarded = true)");
    EXPECT_EQ(errorWith("unguarded = true\n"), "arm.toml:6:13: with this adapter the robot stops by itself, "
                                               "so it is not unguarded (expected false)");
    EXPECT_EQ(errorWith("effort_contains_gravity = true\n"),
              "arm.toml:6:27: the efforts of this arm are not in Nm (expected effort_unit = \"Nm\")");
    EXPECT_EQ(errorWith("effort_unit = \"A\"\n[limits]\neffort_stop = [1, 2]\n"),
              "arm.toml:8:15: the efforts of this arm are not in Nm (expected effort_unit = \"Nm\")");
    EXPECT_EQ(errorWith("[limits]\nstop_deceleration_radPerS2 = 1\n"),
              "arm.toml:7:30: STOP would brake more gently than letting go (expected at least "
              "deceleration_radPerS2, "
              "3)");
}

TEST(RosArmFile, saysWhatTouchesAreEvaluatedWith) {
    const auto file = parseRosArm(kShortest + R"(effort_unit = "Nm"
[touch]
array = "pad.toml"
frame = "forearm"
pose = [0.1, 0.0, -0.03, 3.14, 0.0, 1.57]
joint = "elbow"
joint_stiffness_NmPerRad = [4000, 4000, 0, 2000]
centre_se_mm = 0.5
window_Nm = [0.8, 2.0]
)",
                                  "/files/arm.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    ASSERT_TRUE(file->touch);
    EXPECT_EQ(file->touch->array, "/files/pad.toml");
    const core::PadPlacement& pad = file->touch->pad;
    EXPECT_EQ(pad.link, "forearm");
    EXPECT_EQ(pad.position_m, (std::array{0.1, 0.0, -0.03}));
    EXPECT_EQ(pad.rollPitchYaw_rad, (std::array{3.14, 0.0, 1.57}));
    EXPECT_EQ(pad.joint, "elbow");
    EXPECT_EQ(pad.jointStiffness_NmPerRad, core::JointVector(4000, 4000, 0, 2000));
    EXPECT_DOUBLE_EQ(pad.centreSe_m, 0.0005);
    EXPECT_EQ(pad.torques.windowLow_Nm, 0.8);
    EXPECT_EQ(pad.torques.windowHigh_Nm, 2.0);
    EXPECT_EQ(pad.torques.threshold_Nm, 2.0) << "the window's upper end";
    EXPECT_DOUBLE_EQ(pad.torques.noiseFloor_Nm, 0.1) << "an eighth of its lower end";
    const auto shortest = parseRosArm(kShortest + "effort_unit = \"Nm\"\n[touch]\n", "arm.toml");
    ASSERT_TRUE(shortest && shortest->touch) << core::describe(shortest.error());
    EXPECT_EQ(shortest->touch->array, "");
    EXPECT_EQ(shortest->touch->pad.torques.windowLow_Nm, core::TouchTorques().windowLow_Nm);
}

TEST(RosArmFile, refusesTouchesThatCannotBe) {
    const std::string head = "effort_unit = \"Nm\"\n[touch]\n";
    for (const char* key : {"window_Nm = [1, 2]\n", "threshold_Nm = 1\n", "noise_floor_Nm = 0.01\n",
                            "joint_stiffness_NmPerRad = [1000]\n"})
        EXPECT_NE(errorWith(std::string("[touch]\n") + key).find("not in Nm"), std::string::npos) << key;
    const auto placed =
        parseRosArm(kShortest + "effort_unit = \"A\"\n[touch]\narray = \"pad.toml\"\nframe = \"a\"\n"
                                "pose = [0, 0, 0, 0, 0, 0]\n",
                    "arm.toml");
    EXPECT_TRUE(placed && placed->touch) << "the pad tells the place without torques";
    for (const auto& [lines, told] :
         {std::pair{"pose = [0, 0, 0, 0, 0, 0]\n", "the pad is not named"},
          std::pair{"array = \"pad.toml\"\n", "frame"},
          std::pair{"array = \"pad.toml\"\nframe = \"a\"\npose = [0, 0, 0]\n", "arm.toml:10"},
          std::pair{"window_Nm = [2, 1]\n", "reversed"},
          std::pair{"window_Nm = [1, 2]\nnoise_floor_Nm = 1.5\n", "noise_floor_Nm"},
          std::pair{"threshold_Nm = 0.001\n", "threshold_Nm"}, std::pair{"elbow = 1\n", "elbow"}})
        EXPECT_NE(errorWith(head + lines).find(told), std::string::npos) << errorWith(head + lines);
}

TEST(RosArmFile, aServoHasATopicOfItsOwn) {
    const std::string frames = "kind = \"ros_arm\"\nname = \"Arm\"\nbase_frame = \"base_link\"\n"
                               "tip_frame = \"tool0\"\nadapter = \"moveit_servo\"\n";
    const auto file = parseRosArm(frames, "arm.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->adapter, Adapter::moveitServo);
    EXPECT_EQ(file->commandTopic(), "/servo_node/delta_joint_cmds");
    const auto other = parseRosArm(frames + "controller = \"/left/servo\"\n", "arm.toml");
    ASSERT_TRUE(other) << core::describe(other.error());
    EXPECT_EQ(other->commandTopic(), "/left/servo/delta_joint_cmds");
}

TEST(RosArmFile, aForwardingControllerHasToBeCalledUnguarded) {
    const std::string text = "kind = \"ros_arm\"\nname = \"Arm\"\nbase_frame = \"base_link\"\n"
                             "tip_frame = \"tool0\"\nunguarded = true\ncontroller = \"/forward\"\n";
    for (const Adapter adapter : {Adapter::velocity, Adapter::position}) {
        const auto file =
            parseRosArm(text + "adapter = \"" + std::string(nameOf(adapter)) + "\"\n", "arm.toml");
        ASSERT_TRUE(file) << core::describe(file.error());
        EXPECT_EQ(file->adapter, adapter);
        EXPECT_FALSE(isGuarded(file->adapter));
        EXPECT_EQ(file->commandTopic(), "/forward/commands");
    }
}

TEST(RosArmFile, readsTheFileOfItsForceSensor) {
    const test::TemporaryFolder folder;
    folder.write("ft.toml", "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"/ft/wrench\"\n");
    const std::string arm = folder.write("arm.toml", kShortest + "wrench = \"ft.toml\"\n");
    const auto file = readRosArm(arm);
    ASSERT_TRUE(file) << core::describe(file.error());
    ASSERT_TRUE(file->wrench);
    EXPECT_EQ(file->wrench->topic, "/ft/wrench");
    folder.write("ft.toml", "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"no topic\"\n");
    const auto broken = readRosArm(arm);
    ASSERT_FALSE(broken);
    const std::string text = core::describe(broken.error());
    EXPECT_NE(text.find("arm.toml:6"), std::string::npos) << text;
    EXPECT_NE(text.find("ft.toml:3"), std::string::npos) << text;
    EXPECT_NE(errorWith("wrench = \"none.toml\"\n").find("none.toml"), std::string::npos);
}

} // namespace
} // namespace teleta::ros_arm
