// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/urdf_reader.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <string>

using namespace teleta;
using arm_model::ArmModel;
using arm_model::JointType;

namespace {

const std::string kFolder = TELETA_SOURCE_DIR "/tests/data/urdf/";

/// A robot of two links with this joint between them.
std::string withJoint(const std::string& attributes, const std::string& inside) {
    return "<robot name='r'>\n<link name='a'/>\n<link name='b'/>\n<joint " + attributes +
           ">\n<parent link='a'/><child link='b'/>" + inside + "</joint>\n</robot>\n";
}

const std::string kLimit = "<limit lower='-1' upper='1' effort='10' velocity='2'/>";

core::Error errorOf(const std::string& text) {
    const core::Expected<ArmModel> model = arm_model::parseUrdf(text, "robot.urdf");
    EXPECT_FALSE(model) << text;
    return model ? core::Error{} : model.error();
}

} // namespace

TEST(UrdfReader, readsJointsWithTheirLimits) {
    const core::Expected<ArmModel> model = arm_model::readUrdf(kFolder + "crooked_arm.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    EXPECT_EQ(model->name, "seven");
    EXPECT_EQ(model->links.size(), 9U);
    EXPECT_EQ(model->joints.size(), 8U);
    const std::optional<std::size_t> j4 = model->findJoint("j4");
    ASSERT_TRUE(j4);
    EXPECT_EQ(model->joints[*j4].type, JointType::revolute);
    EXPECT_EQ(model->joints[*j4].lowest, -3.0);
    EXPECT_EQ(model->joints[*j4].highest, 0.1);
    EXPECT_EQ(model->joints[*j4].fastest, 2.1);
    EXPECT_EQ(model->joints[*j4].strongest, 60.0);
    const std::optional<std::size_t> j3 = model->findJoint("j3");
    ASSERT_TRUE(j3);
    EXPECT_EQ(model->joints[*j3].type, JointType::continuous);
    EXPECT_TRUE(std::isinf(model->joints[*j3].highest));
    EXPECT_EQ(model->leaves(), std::vector<std::size_t>{*model->findLink("hand")});
}

TEST(UrdfReader, normalisesAxes) {
    const auto model = arm_model::parseUrdf(
        withJoint("name='j' type='revolute'", "<axis xyz='0 2 0'/>" + kLimit), "robot.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    EXPECT_EQ(model->joints[0].axis, Eigen::Vector3d::UnitY());
}

TEST(UrdfReader, readsWhatLinksLookLike) {
    const core::Expected<ArmModel> model = arm_model::readUrdf(kFolder + "gripper.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto& base = model->links[*model->findLink("base_link")];
    ASSERT_EQ(base.visuals.size(), 1U);
    EXPECT_EQ(base.visuals[0].kind, arm_model::ShapeKind::box);
    EXPECT_EQ(base.visuals[0].size, Eigen::Vector3d(0.1, 0.1, 0.05));
    ASSERT_TRUE(base.visuals[0].colour);
    EXPECT_FLOAT_EQ((*base.visuals[0].colour)[2], 0.7F);
    const auto& lower = model->links[*model->findLink("lower")];
    ASSERT_EQ(lower.visuals.size(), 1U);
    EXPECT_EQ(lower.visuals[0].mesh, "package://gripper/lower.stl");
    EXPECT_EQ(lower.visuals[0].size, Eigen::Vector3d::Constant(0.001));
}

TEST(UrdfReader, followsAMimicToTheJointThatMoves) {
    const std::string text =
        "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>"
        "<joint name='one' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>" +
        kLimit +
        "</joint><joint name='two' type='revolute'><parent link='b'/><child link='c'/><axis xyz='0 0 1'/>" +
        kLimit +
        "<mimic joint='one' multiplier='2' offset='0.1'/></joint>"
        "<joint name='three' type='revolute'><parent link='c'/><child link='d'/><axis xyz='0 0 1'/>" +
        kLimit + "<mimic joint='two' multiplier='3' offset='0.2'/></joint></robot>";
    const auto model = arm_model::parseUrdf(text, "robot.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto& three = model->joints[*model->findJoint("three")];
    ASSERT_TRUE(three.mimic);
    EXPECT_EQ(three.mimic->followed, *model->findJoint("one"));
    EXPECT_DOUBLE_EQ(three.mimic->factor, 6.0);
    EXPECT_DOUBLE_EQ(three.mimic->offset, 0.5); // 3 * 0.1 + 0.2
}

TEST(UrdfReader, readsNumbersUnderALocaleWithCommas) {
    if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr)
        GTEST_SKIP() << "no locale with a decimal comma is installed";
    const auto model = arm_model::parseUrdf(
        withJoint("name='j' type='revolute'", "<origin xyz='0.33 0 0'/><axis xyz='0 0 1'/>" + kLimit),
        "robot.urdf");
    std::setlocale(LC_NUMERIC, "C");
    ASSERT_TRUE(model) << core::describe(model.error());
    EXPECT_DOUBLE_EQ(model->joints[0].X_Parent_Joint.translation().x(), 0.33);
}

TEST(UrdfReader, placesSyntaxErrors) {
    const core::Error error = errorOf("<robot name='r'>\n<link name='a'>\n</robot>");
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_EQ(error.where.file, "robot.urdf");
    EXPECT_EQ(error.where.line, 3);
    EXPECT_GT(error.where.column, 0);
}

TEST(UrdfReader, saysThatXacroMustBeExpanded) {
    const core::Error error = errorOf("<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
                                      "<xacro:arm/>\n</robot>");
    EXPECT_NE(error.message.find("xacro"), std::string::npos);
    EXPECT_EQ(error.where.line, 2);
    EXPECT_NE(error.expected.find("xacro FILE"), std::string::npos);
}

TEST(UrdfReader, refusesWhatIsNoSerialRobot) {
    EXPECT_NE(errorOf("<sdf version='1.6'/>").message.find("sdf"), std::string::npos);
    EXPECT_NE(errorOf("<robot name='r'></robot>").message, "");
    EXPECT_NE(errorOf(withJoint("name='j' type='floating'", "")).message.find("'j'"), std::string::npos);
    EXPECT_NE(errorOf(withJoint("name='j' type='planar'", "<axis xyz='0 0 1'/>")).message.find("'j'"),
              std::string::npos);
    // What the library says comes behind a sentence of our own.
    EXPECT_TRUE(errorOf(withJoint("name='j' type='revolute'", "<axis xyz='0 0 1'/>"))
                    .message.starts_with("this cannot be read as a robot ("));
    EXPECT_NE(
        errorOf(withJoint("name='j' type='revolute'", "<axis xyz='0 0 0'/>" + kLimit)).message.find("axis"),
        std::string::npos);
    EXPECT_NE(errorOf(withJoint("name='j' type='revolute'",
                                "<axis xyz='0 0 1'/><limit lower='1' upper='-1' effort='1' velocity='1'/>"))
                  .message.find("limit"),
              std::string::npos);
    EXPECT_NE(errorOf(withJoint("name='j' type='revolute'",
                                "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='-1'/>"))
                  .message.find("velocity"),
              std::string::npos);
}

/// As humanoids of NASA have them.
TEST(UrdfReader, takesALimitOfAnyEffortAsNoLimit) {
    const auto model = arm_model::parseUrdf(
        withJoint("name='j' type='revolute'",
                  "<axis xyz='0 0 1'/><limit lower='-3' upper='3' effort='1e10' velocity='1e7'/>"),
        "robot.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    EXPECT_EQ(model->joints[0].strongest, 1e6);
    EXPECT_EQ(model->joints[0].fastest, 1e6);
    EXPECT_NE(errorOf(withJoint("name='j' type='revolute'",
                                "<axis xyz='0 0 1'/><limit lower='-1e9' upper='3' effort='9' velocity='1'/>"))
                  .message.find("out of range"),
              std::string::npos);
}

TEST(UrdfReader, refusesCirclesOfLinksAndOfMimics) {
    EXPECT_NE(errorOf("<robot name='r'><link name='a'/><link name='b'/>"
                      "<joint name='x' type='fixed'><parent link='a'/><child link='b'/></joint>"
                      "<joint name='y' type='fixed'><parent link='b'/><child link='a'/></joint></robot>")
                  .message,
              "");
    EXPECT_NE(
        errorOf(withJoint("name='j' type='revolute'", "<axis xyz='0 0 1'/>" + kLimit + "<mimic joint='j'/>"))
            .message.find("mimics itself"),
        std::string::npos);
    EXPECT_NE(
        errorOf(withJoint("name='j' type='revolute'", "<axis xyz='0 0 1'/>" + kLimit + "<mimic joint='k'/>"))
            .message.find("'k'"),
        std::string::npos);
}

TEST(UrdfReader, doesNotPrintWhatTheLibraryReports) {
    testing::internal::CaptureStderr();
    const core::Error error = errorOf("<robot name='r'><link name='a'/><link name='a'/></robot>");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(error.message.find("'a'"), std::string::npos) << error.message;
}

TEST(UrdfReader, refusesElementsThatWouldExhaustTheStack) {
    std::string text = "<robot name='r'>";
    for (int i = 0; i < 100'000; ++i)
        text += "<a>";
    EXPECT_NE(errorOf(text).message.find("nested"), std::string::npos);
}

TEST(UrdfReader, namesAFileThatIsMissing) {
    const auto model = arm_model::readUrdf("/nowhere/robot.urdf");
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().kind, core::ErrorKind::notFound);
    EXPECT_FALSE(arm_model::readUrdf(kFolder));
}
