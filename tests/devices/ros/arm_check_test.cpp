// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/urdf_reader.h"
#include "devices/ros/arm_chain.h"
#include "devices/ros/check/arm_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

namespace teleta::ros_arm {
namespace {

arm_model::SerialChain sevenJoints() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
    return *arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model), "base_link",
                                           "tool0");
}

dds::FoundEnd endOf(const char* topic, bool writes, const char* type) {
    dds::FoundEnd end;
    end.ddsTopic = topic;
    end.ddsType = type;
    end.writes = writes;
    end.profile = ros::kCommandWriter;
    return end;
}

constexpr const char* kCommands = "rt/arm_controller/joint_trajectory";
constexpr const char* kTrajectory = "trajectory_msgs::msg::dds_::JointTrajectory_";

RosArmFile fileOf(const std::string& more = {}) {
    const auto file = parseRosArm("kind = \"ros_arm\"\nname = \"Arm\"\nbase_frame = \"base_link\"\n"
                                  "tip_frame = \"tool0\"\ncontroller = \"/arm_controller\"\n"
                                  "effort_unit = \"Nm\"\n" +
                                      more,
                                  "arm.toml");
    EXPECT_TRUE(file) << core::describe(file.error());
    return *file;
}

ArmObservation goodArm() {
    ArmObservation seen;
    seen.time_s = 5.0;
    seen.samples = 500;
    seen.longestGap_s = 0.012;
    seen.effortTold = true;
    seen.counters.messages = 500;
    seen.clockDifference_s = 0.002;
    seen.ends = {endOf("rt/joint_states", true, "sensor_msgs::msg::dds_::JointState_"),
                 endOf(kCommands, false, kTrajectory)};
    return seen;
}

/// Texts of the problems, or of the notes, of a check.
std::string textsOf(const std::vector<ArmFinding>& findings, const std::string& check,
                    FindingLevel level = FindingLevel::problem) {
    std::string texts;
    for (const ArmFinding& finding : findings) {
        if (finding.check == check && finding.level == level)
            texts += finding.text.toStdString() + ";";
    }
    return texts;
}

bool canMove(const std::vector<ArmFinding>& findings) {
    return std::ranges::none_of(
        findings, [](const ArmFinding& finding) { return finding.level == FindingLevel::problem; });
}

} // namespace

TEST(ArmCheck, anArmInOrderHasNothingInItsWay) {
    const std::vector<ArmFinding> findings = findingsOf(fileOf(), sevenJoints(), goodArm());
    EXPECT_TRUE(canMove(findings));
    EXPECT_EQ(textsOf(findings, "joints", FindingLevel::good), "/joint_states reports all 7 joints;");
    EXPECT_EQ(textsOf(findings, "rate", FindingLevel::good), "100 samples a second, longest gap 0.012 s;");
    EXPECT_EQ(textsOf(findings, "clock", FindingLevel::good), "stamps are 0.002 s behind this computer;");
}

TEST(ArmCheck, saysWhatIsWrongWithTheJoints) {
    ArmObservation seen = goodArm();
    seen.missing = {"joint_7"};
    seen.unknown = {"joint_8"};
    seen.counters.malformed = 2;
    seen.fault = ArmFault{ArmFaultKind::jumped, "joint_1"};
    const std::vector<ArmFinding> findings = findingsOf(fileOf(), sevenJoints(), seen);
    EXPECT_EQ(textsOf(findings, "joints"),
              "/joint_states does not report: joint_7;the position of joint_1 jumped;");
    EXPECT_EQ(textsOf(findings, "joints", FindingLevel::note),
              "/joint_states reports joint_8, which the arm does not have;"
              "2 messages were inconsistent and were ignored;");
    seen = goodArm();
    seen.counters.messages = seen.samples = 0;
    seen.ends.clear();
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "joints"),
              "nobody publishes /joint_states;");
    seen = goodArm();
    seen.longestGap_s = 0.25;
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "rate"),
              "100 samples a second, longest gap 0.25 s; joint_timeout_s is 0.1;");
}

TEST(ArmCheck, aClockThatIsOffIsToldAndDoesNotHoldTheArm) {
    ArmObservation seen = goodArm();
    seen.clockDifference_s = -10.0;
    seen.zeroStamps = 3;
    const std::vector<ArmFinding> findings = findingsOf(fileOf(), sevenJoints(), seen);
    EXPECT_TRUE(canMove(findings));
    EXPECT_EQ(textsOf(findings, "clock", FindingLevel::note),
              "3 stamps are zero;stamps are -10 s behind this computer;");
}

TEST(ArmCheck, aLimitThatCannotActHoldsTheArm) {
    ArmObservation seen = goodArm();
    seen.effortTold = false;
    EXPECT_TRUE(canMove(findingsOf(fileOf(), sevenJoints(), seen)));
    const std::string efforts = "[limits]\neffort_stop = [1, 1, 1, 1, 1, 1, 1]\n";
    EXPECT_EQ(textsOf(findingsOf(fileOf(efforts), sevenJoints(), seen), "effort"),
              "not reported, so effort_stop cannot work;");
    EXPECT_EQ(
        textsOf(findingsOf(fileOf("[limits]\neffort_stop = [1, 1]\n"), sevenJoints(), goodArm()), "file"),
        "effort_stop has 2 numbers, the arm has 7 joints;");
    RosArmFile forces = fileOf("[limits]\nforce_stop_N = 30\n");
    EXPECT_EQ(textsOf(findingsOf(forces, sevenJoints(), goodArm()), "file"),
              "force_stop_N needs a force sensor: wrench = \"FILE\" names the file of one;");
    forces.wrench.emplace().topic = "/ft/wrench";
    EXPECT_TRUE(obstacles(forces, sevenJoints()).isEmpty());
    forces.wrench->frame = "ft_sensor";
    EXPECT_EQ(textsOf(findingsOf(forces, sevenJoints(), goodArm()), "file"),
              "the force sensor is in the frame ft_sensor, which the description does not have;");
    forces.wrench->frame = "tool0";
    forces.wrench->domain.emplace().domain = 5;
    EXPECT_EQ(obstacles(forces, sevenJoints()).size(), 1);
    EXPECT_EQ(textsOf(findingsOf(fileOf("[joint_names]\nelbow = \"e\"\n"), sevenJoints(), goodArm()), "file"),
              "[joint_names] names elbow, which is not in the description;");
}

TEST(ArmCheck, aForceSensorHasToTellSmallForcesInTime) {
    RosArmFile file = fileOf("[limits]\nforce_stop_N = 30\n");
    file.wrench.emplace().topic = "/ft/wrench";
    ArmObservation seen = goodArm();
    const auto texts = [&](FindingLevel level) {
        return textsOf(findingsOf(file, sevenJoints(), seen), "force", level);
    };
    seen.wrench.emplace();
    EXPECT_EQ(texts(FindingLevel::problem), "/ft/wrench reports no force;");
    seen.wrench =
        WrenchObservation{.messages = 500, .longestGap_s = 0.02, .strongest_N = 4.0, .unknownFrame = {}};
    EXPECT_EQ(texts(FindingLevel::good), "100 messages a second, longest gap 0.02 s, at most 4 N;");
    seen.wrench->strongest_N = 31.0;
    EXPECT_NE(texts(FindingLevel::problem).find("force_stop_N is 30"), std::string::npos);
    seen.wrench->strongest_N = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(texts(FindingLevel::problem), "");
    seen.wrench->strongest_N = 4.0;
    seen.wrench->longestGap_s = 0.3;
    EXPECT_NE(texts(FindingLevel::problem).find("timeout_s is 0.1"), std::string::npos);
    seen.wrench->unknownFrame = "ft_sensor";
    EXPECT_NE(texts(FindingLevel::problem).find("ft_sensor"), std::string::npos);
    file.limits.forceStop_N.reset();
    EXPECT_NE(texts(FindingLevel::note), "") << "nothing depends on it";
}

TEST(ArmCheck, aTipThatIsNotWhereTheRobotHasItBelongsToAnotherDescription) {
    ArmObservation seen = goodArm();
    const auto texts = [&](FindingLevel level) {
        return textsOf(findingsOf(fileOf(), sevenJoints(), seen), "frames", level);
    };
    EXPECT_EQ(texts(FindingLevel::good) + texts(FindingLevel::note) + texts(FindingLevel::problem), "")
        << "not every robot has frames";
    seen.frames.messages = 100;
    EXPECT_EQ(texts(FindingLevel::note), "/tf does not lead from base_link to tool0;");
    seen.frames.connected = true;
    EXPECT_EQ(texts(FindingLevel::note), "/tf has no pose of the time of a joint sample;");
    seen.frames.compared = 90;
    seen.frames.farthest_m = 0.0002;
    EXPECT_EQ(texts(FindingLevel::good), "the tip is where /tf has it: 0.20 mm and 0.00° off at most;");
    seen.frames.farthest_m = 0.004;
    EXPECT_EQ(texts(FindingLevel::note), "the tip is not where /tf has it: 4.00 mm and 0.00° off at most;");
    seen.frames.largestTurn_rad = 0.1;
    EXPECT_EQ(texts(FindingLevel::problem),
              "the tip is not where /tf has it: 4.00 mm and 5.73° off at most; the "
              "description is another robot's, or a joint has another zero;");
}

TEST(ArmCheck, moveItServoIsForSitesOnly) {
    RosArmFile file = fileOf();
    file.adapter = Adapter::moveitServo;
    file.controller = "/servo_node";
    EXPECT_EQ(obstacles(file, sevenJoints()).size(), 1);
    const core::RequiredDevices atASite;
    EXPECT_TRUE(obstacles(file, sevenJoints(), &atASite).isEmpty());
    ArmObservation seen = goodArm();
    seen.ends[1] = endOf("rt/servo_node/delta_joint_cmds", false, "control_msgs::msg::dds_::JointJog_");
    EXPECT_EQ(textsOf(findingsOf(file, sevenJoints(), seen), "controller", FindingLevel::good),
              "reads /servo_node/delta_joint_cmds;");
}

TEST(ArmCheck, requiredDevicesHaveToBeWatchedBySomebody) {
    const RosArmFile file = fileOf("required = [\"pad\"]\n");
    EXPECT_FALSE(canMove(findingsOf(file, sevenJoints(), goodArm())));
    const core::RequiredDevices known;
    EXPECT_TRUE(obstacles(file, sevenJoints(), &known).isEmpty());
}

TEST(ArmCheck, saysWhyTheControllerIsNotReached) {
    ArmObservation seen = goodArm();
    seen.ends[1].profile.durability = ros::Durability::transientLocal;
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "controller"),
              "cannot be reached: the publisher is volatile, the subscriber asks for transient local;");
    seen.ends[1] = endOf(kCommands, false, "std_msgs::msg::dds_::String_");
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "controller"),
              "cannot be reached: /arm_controller/joint_trajectory has the type std_msgs/msg/String;");
    seen.ends[1] = endOf("rt/left/joint_trajectory", false, kTrajectory);
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "controller"),
              "nobody reads /arm_controller/joint_trajectory; found: /left/joint_trajectory;");
    seen = goodArm();
    seen.ends.push_back(endOf(kCommands, true, kTrajectory));
    EXPECT_EQ(textsOf(findingsOf(fileOf(), sevenJoints(), seen), "writers"),
              "someone else commands /arm_controller/joint_trajectory;");
}

} // namespace teleta::ros_arm
