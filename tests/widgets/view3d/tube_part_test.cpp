// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/camera/sample_camera.h"
#include "tests/widgets/view3d/empty_scene.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <limits>

using namespace teleta;
using pipeline::CarrierReport;
using view3d::TouchScene;

TEST(TubePart, isAsLargeAsItsSurfaceAndFollowsItsArm) {
    TouchScene scene = test::emptyScene();
    EXPECT_TRUE(scene.isEmpty());
    pipeline::CameraSnapshot snapshot = test::sampleCamera();
    EXPECT_TRUE(scene.setTube(&snapshot));
    EXPECT_FALSE(scene.isEmpty());
    Eigen::AlignedBox3d box = scene.tube().box_m();
    EXPECT_NEAR(box.max().z(), 0.1, 1e-12);
    EXPECT_GE(box.max().x(), 0.025);
    snapshot.carrier = CarrierReport{};
    snapshot.carrier->X_Base_Sensor.translation() = Eigen::Vector3d(-0.01, 0.0, 0.01);
    EXPECT_FALSE(scene.setTube(&snapshot)) << "a small way: the camera need not be fitted anew";
    snapshot.carrier->X_Base_Sensor.translation() = Eigen::Vector3d(-0.03, 0.0, 0.06);
    EXPECT_TRUE(scene.setTube(&snapshot));
    EXPECT_FALSE(scene.setTube(&snapshot));
    box = scene.tube().box_m();
    EXPECT_NEAR(box.max().z(), 0.16, 1e-12);
    EXPECT_LT(box.min().x(), -0.055);
    EXPECT_GE(box.max().x(), 0.025) << "where it started stays in the picture";
    EXPECT_TRUE(scene.setTube(nullptr));
    EXPECT_TRUE(scene.isEmpty());
}

TEST(TubePart, marksAContactOnTheSkinWithItsDeviation) {
    TouchScene scene = test::emptyScene();
    pipeline::CameraSnapshot snapshot = test::sampleCamera();
    snapshot.bump = vision::BumpDetector::Bump{.contact = 3};
    scene.setTube(&snapshot);
    ASSERT_EQ(scene.tube().marks().size(), 1U);
    const view3d::TubeMark& mark = scene.tube().marks().front();
    EXPECT_EQ(mark.id, 3);
    EXPECT_TRUE(mark.bumps);
    EXPECT_DOUBLE_EQ(mark.sd_m, 0.0002);
    EXPECT_NEAR(mark.p_Sensor_Foot.head<2>().norm(), 0.025, 0.0005);
    EXPECT_NEAR(mark.p_Sensor_Foot.z(), 0.040, 1e-12);
}

TEST(TubePart, whatNoRayMeetsAndWhatIsOnlyNoiseIsNotDrawn) {
    TouchScene scene = test::emptyScene();
    pipeline::CameraSnapshot snapshot = test::sampleCamera();
    scene.setTube(&snapshot);
    // Outline, way, region and one of the two vectors: the other is smaller than its deviation.
    EXPECT_EQ(test::linesIn(scene), 4);
    scene.setDisplacementShown(false);
    EXPECT_EQ(test::linesIn(scene), 3);
    snapshot.contacts.front().contact.located = false;
    snapshot.covariances_m2.front().setConstant(std::numeric_limits<double>::quiet_NaN());
    scene.setTube(&snapshot);
    EXPECT_TRUE(scene.tube().marks().empty());
    EXPECT_EQ(test::linesIn(scene), 0);
}

TEST(TubePart, theRegionHoldsNinetyFivePercent) {
    TouchScene scene = test::emptyScene();
    pipeline::CameraSnapshot snapshot = test::sampleCamera();
    snapshot.contacts.front().contact.contour_m.clear();
    snapshot.contacts.front().p_Sensor_Start_m = snapshot.contacts.front().contact.p_Sensor_Centre_m;
    snapshot.vectors.clear();
    scene.setTube(&snapshot);
    ASSERT_EQ(test::linesIn(scene), 1);
    for (const auto& mesh : scene.worldMeshes()) {
        if (mesh->GetNumberOfLines() == 0)
            continue;
        double bounds[6];
        mesh->GetBounds(bounds);
        // 2.4477 = sqrt(5.991), the 95 % quantile of chi-square with two degrees of freedom.
        EXPECT_NEAR(bounds[5] - bounds[4], 2.0 * 2.4477 * 0.0003, 2e-6);
        EXPECT_NEAR(bounds[1] - bounds[0], 2.0 * 2.4477 * 0.0001, 2e-5);
    }
}

TEST(TubePart, aSurfaceThatIsNoneIsNotDrawn) {
    TouchScene scene = test::emptyScene();
    pipeline::CameraSnapshot snapshot = test::sampleCamera();
    snapshot.surface.radius_m = std::numeric_limits<double>::quiet_NaN();
    scene.setTube(&snapshot);
    EXPECT_TRUE(scene.isEmpty());
}
