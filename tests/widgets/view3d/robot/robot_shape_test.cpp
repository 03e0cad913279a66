// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of links against the volumes of their solids.
#include "backend/arm_model/urdf_reader.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/widgets/view3d/robot/mesh_measures.h"
#include "widgets/view3d/robot/robot_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace teleta::view3d {
namespace {

/// Of a regular polygon of 32 sides instead of its circle.
const double kPolygon = 16.0 * std::sin(std::numbers::pi / 16.0) / std::numbers::pi;

arm_model::ArmModel modelWith(const std::string& visuals) {
    const auto model =
        arm_model::parseUrdf("<robot name=\"r\"><link name=\"base\"/><link name=\"tip\">" + visuals +
                                 "</link><joint name=\"j\" type=\"fixed\"><parent link=\"base\"/>"
                                 "<child link=\"tip\"/></joint></robot>",
                             "robot.urdf");
    EXPECT_TRUE(model) << core::describe(model.error());
    return model.value_or(arm_model::ArmModel());
}

} // namespace

TEST(RobotShape, solidsHaveTheirVolumes) {
    EXPECT_NEAR(volume_m3(boxMesh({0.1, 0.2, 0.3})), 0.006, 1e-8);
    EXPECT_NEAR(volume_m3(cylinderMesh(0.1, 0.5)), kPolygon * std::numbers::pi * 0.01 * 0.5, 1e-7);
    // An inscribed polyhedron has less than the ball, by some of a hundredth here.
    const double ball = 4.0 / 3.0 * std::numbers::pi * 0.001;
    EXPECT_LT(volume_m3(sphereMesh(0.1)), ball);
    EXPECT_GT(volume_m3(sphereMesh(0.1)), 0.97 * ball);
    for (const TriangleMesh& mesh : {boxMesh({0.1, 0.2, 0.3}), cylinderMesh(0.1, 0.5), sphereMesh(0.1)}) {
        EXPECT_TRUE(normalsLookOut(mesh));
        EXPECT_EQ(mesh.points_m.size(), mesh.normals.size());
        EXPECT_EQ(mesh.points_m.size(), mesh.colours.size());
    }
}

TEST(RobotShape, aMirroredPartStillLooksOut) {
    TriangleMesh mesh;
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    place.translate(Eigen::Vector3d(1.0, 2.0, 3.0)).scale(Eigen::Vector3d(-2.0, 1.0, 0.5));
    mesh.append(boxMesh({0.1, 0.2, 0.3}), place);
    EXPECT_NEAR(volume_m3(mesh), 0.006, 1e-6);
    EXPECT_TRUE(normalsLookOut(mesh));
    EXPECT_TRUE(boxOf(mesh).center().isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-6));
}

TEST(RobotShape, visualsOfALink) {
    const auto robot = loadRobotShape(
        modelWith("<visual><origin xyz=\"1 0 0\"/><geometry><box size=\"0.1 0.1 0.1\"/></geometry>"
                  "<material name=\"m\"><color rgba=\"0 1 0 1\"/></material></visual>"
                  "<visual><geometry><sphere radius=\"0.1\"/></geometry></visual>"),
        "");
    ASSERT_TRUE(robot) << core::describe(robot.error());
    ASSERT_EQ(robot->links.size(), 2U);
    EXPECT_TRUE(robot->links[0].corners.empty());
    const TriangleMesh& tip = robot->links[1];
    EXPECT_NEAR(volume_m3(tip), 1e-3 + volume_m3(sphereMesh(0.1)), 1e-6);
    EXPECT_EQ(tip.colours.front(), qRgb(0, 255, 0));
    EXPECT_EQ(qAlpha(tip.colours.back()), 0);
    EXPECT_FALSE(robot->isEmpty());
    EXPECT_TRUE(loadRobotShape(modelWith(""), "")->isEmpty());
}

TEST(RobotShape, meshesAreScaledAndShared) {
    const test::TemporaryFolder folder;
    folder.write("cone.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const std::string visual =
        "<visual><geometry><mesh filename=\"cone.obj\" scale=\"0.1 0.1 0.2\"/></geometry>"
        "<material name=\"m\"><color rgba=\"0 0 1 1\"/></material></visual>";
    const auto robot = loadRobotShape(modelWith(visual + visual), folder.path(""));
    ASSERT_TRUE(robot) << core::describe(robot.error());
    EXPECT_NEAR(volume_m3(robot->links[1]), 2.0 * 0.002 / 6.0, 1e-9);
    EXPECT_EQ(robot->links[1].triangles(), 8U);
    EXPECT_EQ(robot->links[1].colours.front(), qRgb(0, 0, 255));

    const auto missing = loadRobotShape(
        modelWith(visual + "<visual><geometry><mesh filename=\"package://r/none.stl\"/></geometry></visual>"),
        folder.path(""));
    ASSERT_FALSE(missing);
    EXPECT_NE(core::describe(missing.error()).find("r/none.stl: the mesh is missing"), std::string::npos)
        << core::describe(missing.error());
}

TEST(RobotShape, theBundledArmsNeedNoFolder) {
    for (const char* arm : {"four-joints.urdf", "seven-joints.urdf"}) {
        const auto model = arm_model::readUrdf(std::string(TELETA_SOURCE_DIR "/resources/arms/") + arm);
        ASSERT_TRUE(model);
        const auto robot = loadRobotShape(*model, "");
        ASSERT_TRUE(robot) << core::describe(robot.error());
        EXPECT_FALSE(robot->isEmpty());
    }
}

} // namespace teleta::view3d
