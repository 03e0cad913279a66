// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/camera/sample_gel.h"
#include "tests/widgets/view3d/empty_scene.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace teleta;
using view3d::GelWords;
using view3d::TouchScene;

namespace {

constexpr double kEnlargement = 4.0;

const std::vector<GelWords> kWords{
    {QStringLiteral("slip 0.42"), QStringLiteral("Contact 2\nturned"), {Qt::darkYellow, Qt::yellow}}};

std::vector<Eigen::AlignedBox3d> boxesOf(const TouchScene& scene) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const auto& mesh : scene.worldMeshes()) {
        double b[6];
        mesh->GetBounds(b);
        boxes.push_back({Eigen::Vector3d(b[0], b[2], b[4]), Eigen::Vector3d(b[1], b[3], b[5])});
    }
    return boxes;
}

/// Around the meshes that a switch takes away.
template <typename Switch>
Eigen::AlignedBox3d switched(TouchScene& scene, Switch set) {
    const std::vector<Eigen::AlignedBox3d> all = boxesOf(scene);
    set(scene, false);
    const std::vector<Eigen::AlignedBox3d> fewer = boxesOf(scene);
    set(scene, true);
    Eigen::AlignedBox3d gone;
    for (const Eigen::AlignedBox3d& box : all)
        if (std::ranges::none_of(fewer, [&](const auto& other) { return other.isApprox(box, 0.0); }))
            gone.extend(box);
    return gone;
}

} // namespace

TEST(GelPart, isAsLargeAsItsPictureOnTheSurfaceAndLiesInTheMiddle) {
    TouchScene scene = test::emptyScene();
    const pipeline::GelSnapshot snapshot = test::sampleGel();
    EXPECT_TRUE(scene.setGel(&snapshot, kEnlargement, kWords));
    EXPECT_FALSE(scene.isEmpty());
    // 320 x 240 pixels of 0.1 mm.
    EXPECT_NEAR(scene.gel().width_m(), 0.032, 1e-12);
    EXPECT_NEAR(scene.gel().height_m(), 0.024, 1e-12);
    const Eigen::AlignedBox3d box = scene.gel().box_m();
    EXPECT_NEAR(box.min().x(), -0.016, 1e-12);
    EXPECT_NEAR(box.max().x(), 0.016, 1e-12);
    EXPECT_NEAR(box.min().y(), -0.012, 1e-12);
    EXPECT_NEAR(box.max().y(), 0.012, 1e-12);
    EXPECT_FALSE(scene.setGel(&snapshot, kEnlargement, kWords)) << "the camera need not be fitted anew";
    EXPECT_TRUE(scene.setGel(nullptr, kEnlargement, {}));
    EXPECT_TRUE(scene.isEmpty());
}

TEST(GelPart, withoutCornersItIsAsLargeAsWhatTheMarkersCover) {
    TouchScene scene = test::emptyScene();
    pipeline::GelSnapshot snapshot = test::sampleGel();
    snapshot.corners_m[2].setConstant(std::numeric_limits<double>::quiet_NaN());
    scene.setGel(&snapshot, kEnlargement, kWords);
    // The markers cover a square of 16 mm; 5 % of its diagonal around it.
    EXPECT_NEAR(scene.gel().width_m(), 0.016 * (1.0 + 0.1 * std::sqrt(2.0)), 1e-12);
    EXPECT_NEAR(scene.gel().height_m(), scene.gel().width_m(), 1e-12);
}

TEST(GelPart, aMarkersArrowIsItsDisplacementEnlarged) {
    for (const double enlargement : {1.0, 4.0, 16.0}) {
        TouchScene scene = test::emptyScene();
        const pipeline::GelSnapshot snapshot = test::sampleGel();
        scene.setGel(&snapshot, enlargement, kWords);
        const auto arrows =
            switched(scene, [](TouchScene& of, bool shown) { of.setDisplacementShown(shown); });
        // The marker at (16, 12) mm went 0.5 mm along x; the middle is (15.95, 11.95) mm.
        EXPECT_NEAR(arrows.min().x(), 5e-5, 1e-6);
        EXPECT_NEAR(arrows.max().x(), 5e-5 + enlargement * 5e-4, 1e-6);
        EXPECT_NEAR(arrows.center().y(), 5e-5, 1e-6);
    }
}

TEST(GelPart, aLostMarkerIsACrossAndAGelThatIsNotFollowedHasNone) {
    TouchScene scene = test::emptyScene();
    pipeline::GelSnapshot snapshot = test::sampleGel();
    scene.setGel(&snapshot, kEnlargement, kWords);
    EXPECT_EQ(test::linesIn(scene), 3) << "the outline of the contact and a cross";
    snapshot.usable = false;
    snapshot.contacts.clear();
    scene.setGel(&snapshot, kEnlargement, {});
    EXPECT_EQ(test::linesIn(scene), 0);
}

TEST(GelPart, contactsAreMarkedInTheWordsOfThePicture) {
    TouchScene scene = test::emptyScene();
    const pipeline::GelSnapshot snapshot = test::sampleGel();
    scene.setGel(&snapshot, kEnlargement, kWords);
    ASSERT_EQ(scene.gel().marks().size(), 1U);
    const view3d::GelMark& mark = scene.gel().marks().front();
    EXPECT_EQ(mark.id, 2);
    EXPECT_EQ(mark.words.slip, QStringLiteral("slip 0.42"));
    EXPECT_EQ(mark.words.all, QStringLiteral("Contact 2\nturned"));
    const Eigen::Vector3d foot = scene.gel().X_World_Sensor() * mark.p_Sensor_Foot;
    EXPECT_NEAR(foot.x(), 5e-5, 1e-9);
    EXPECT_NEAR(foot.y(), 5e-5, 1e-9);
}

TEST(GelPart, arrowsThatPressAreInProportionToTheSpreadOfTheSkin) {
    const auto reach_m = [](double least_m2, double spread_m2) {
        TouchScene scene = test::emptyScene();
        pipeline::GelSnapshot snapshot = test::sampleGel();
        snapshot.contacts.push_back(snapshot.contacts.front());
        snapshot.contacts[0].normalProxy_m2 = spread_m2;
        snapshot.contacts[1].normalProxy_m2 = least_m2;
        scene.setGel(&snapshot, kEnlargement, kWords);
        EXPECT_NEAR(scene.gel().spreadRange_m2(), 2e-5, 1e-18) << "the largest, which is a round number";
        return (scene.gel().marks()[0].p_Sensor_Tail - scene.gel().marks()[0].p_Sensor_Foot).z();
    };
    const double none_m = reach_m(2e-5, 0.0);
    const double quarter_m = reach_m(2e-5, 0.5e-5);
    const double half_m = reach_m(2e-5, 1e-5);
    EXPECT_EQ(none_m, 0.0) << "nothing presses";
    const double whole_m = reach_m(2e-5, 2e-5);
    // From the top of the mark on.
    EXPECT_NEAR(whole_m - half_m, 2.0 * (half_m - quarter_m), 1e-9);
    EXPECT_GT(whole_m, half_m);
}

TEST(GelPart, theArrowAroundAContactTurnsAsItDoes) {
    for (const double torsion_rad : {0.1, -0.1}) {
        TouchScene scene = test::emptyScene();
        pipeline::GelSnapshot snapshot = test::sampleGel();
        snapshot.contacts.front().torsion_rad = torsion_rad;
        scene.setGel(&snapshot, kEnlargement, kWords);
        const auto turn = switched(scene, [](TouchScene& of, bool shown) { of.setTurnsShown(shown); });
        // From x towards y, seen from where z points to.
        const double beside_m = turn.center().y() - 5e-5;
        EXPECT_GT(beside_m * torsion_rad, 0.0);
        snapshot.contacts.front().torsion_rad = 2.0 * torsion_rad;
        scene.setGel(&snapshot, kEnlargement, kWords);
        const auto more = switched(scene, [](TouchScene& of, bool shown) { of.setTurnsShown(shown); });
        EXPECT_GT(more.sizes().y(), 1.5 * turn.sizes().y());
        snapshot.contacts.front().torsion_rad = 0.0;
        scene.setGel(&snapshot, kEnlargement, kWords);
        EXPECT_TRUE(switched(scene, [](TouchScene& of, bool shown) { of.setTurnsShown(shown); }).isEmpty());
    }
}

TEST(GelPart, shearIsEnlargedAlongItsDirection) {
    TouchScene scene = test::emptyScene();
    pipeline::GelSnapshot snapshot = test::sampleGel();
    snapshot.contacts.front().normalProxy_m2 = 0.0;
    snapshot.contacts.front().shearProxy_m = {0.0, 2e-3};
    scene.setGel(&snapshot, kEnlargement, kWords);
    const auto arrows = switched(scene, [](TouchScene& of, bool shown) { of.setForcesShown(shown); });
    EXPECT_NEAR(arrows.max().y(), 5e-5 + kEnlargement * 2e-3, 1e-6);
    EXPECT_NEAR(arrows.center().x(), 5e-5, 1e-6);
}

TEST(GelPart, nothingIsDrawnBeforeTheRestIsKnownAndAfterwardsWithoutIt) {
    TouchScene scene = test::emptyScene();
    pipeline::GelSnapshot snapshot = test::sampleGel();
    const auto markers = std::exchange(snapshot.markers, {});
    EXPECT_FALSE(scene.setGel(&snapshot, kEnlargement, kWords));
    EXPECT_TRUE(scene.isEmpty());
    snapshot.markers = markers;
    EXPECT_TRUE(scene.setGel(&snapshot, kEnlargement, kWords));
    snapshot.markers.clear();
    EXPECT_TRUE(scene.setGel(&snapshot, kEnlargement, kWords));
    EXPECT_TRUE(scene.isEmpty());
}
