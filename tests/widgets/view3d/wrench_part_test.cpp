// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/marks/limit_part.h"
#include "widgets/view3d/marks/wrench_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta;
using contact::TactileFeatures;
using view3d::WrenchPart;

namespace {

constexpr core::ArrayLayout kFlat{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

/// Of a frame, by the program's own extractor.
TactileFeatures featuresOf(const pipeline::TouchSnapshot& snapshot) {
    contact::FeatureExtractor extractor(snapshot.layout.grid(), {.threshold_N = snapshot.threshold_N});
    return extractor.compute(snapshot.load_N);
}

pipeline::TouchSnapshot slanted(std::uint64_t frame = 1) {
    pipeline::TouchSnapshot snapshot =
        test::pressed(kFlat, {{1, -0.012, 0.001, 1.2}, {2, 0.011, 0.002, 0.6}}, frame);
    snapshot.features = featuresOf(snapshot);
    return snapshot;
}

struct Drawn {
    Drawn() { wrench.addTo(scene.renderer()); }
    void show(const pipeline::TouchSnapshot& snapshot) {
        ASSERT_EQ(scene.take(snapshot), view3d::TouchScene::Taken::fresh);
        wrench.take(snapshot);
        scene.draw();
        wrench.draw(scene);
    }
    view3d::TouchScene scene{view3d::SceneColours(base::designedPalette(true))};
    WrenchPart wrench;
};

} // namespace

TEST(MomentOfLoads, isTheSumOfEachTaxelsMomentAboutTheCentreOfContact) {
    const pipeline::TouchSnapshot snapshot = slanted();
    const TactileFeatures& features = snapshot.features;
    // Each load presses along -z: M = sum r x (0, 0, -f).
    Eigen::Vector3d sum_Nm = Eigen::Vector3d::Zero();
    std::size_t taxel = 0;
    for (int row = 0; row < kFlat.rows; ++row)
        for (int column = 0; column < kFlat.columns; ++column, ++taxel) {
            const Eigen::Vector3d r_m(kFlat.x_m(column) - *features.cocX_m, kFlat.y_m(row) - *features.cocY_m,
                                      0.0);
            sum_Nm += r_m.cross(Eigen::Vector3d(0.0, 0.0, -static_cast<double>(snapshot.load_N[taxel])));
        }
    const auto moment_Nm = view3d::momentOf_Nm(features);
    ASSERT_TRUE(moment_Nm);
    EXPECT_GT(moment_Nm->norm(), 1e-3);
    EXPECT_LT((*moment_Nm - sum_Nm).norm(), 1e-6 * sum_Nm.norm());
}

TEST(MomentOfLoads, isEmptyWithoutAContact) {
    EXPECT_FALSE(view3d::momentOf_Nm(featuresOf(test::pressed(kFlat, {}))));
    TactileFeatures features = slanted().features;
    features.force_N = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(view3d::momentOf_Nm(features));
}

TEST(WrenchPart, theForceEndsWhereItActsAndIsAsLongAsAContactsArrow) {
    Drawn drawn;
    const Eigen::Vector3d p(0.1, 0.2, 0.3);
    drawn.scene.setForce(view3d::DrawnForce{p, {0.0, 3.0, 0.0}});
    drawn.wrench.setForce(view3d::DrawnForce{p, {0.0, 3.0, 0.0}});
    drawn.show(slanted());
    ASSERT_TRUE(drawn.wrench.forceTail());
    EXPECT_GE(drawn.scene.forceRange_N(), 3.0) << "one scale for all forces";
    const Eigen::Vector3d along = p - *drawn.wrench.forceTail();
    EXPECT_LT(along.cross(Eigen::Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_NEAR(along.y(), 3.0 / drawn.scene.forceRange_N() * drawn.scene.sensorSize().arrow_m, 1e-12);
    drawn.wrench.setForce(std::nullopt);
    drawn.wrench.draw(drawn.scene);
    EXPECT_FALSE(drawn.wrench.forceTail());
}

TEST(WrenchPart, aMeasuredForceNeedsAnArmButNoArray) {
    Drawn drawn;
    const Eigen::Vector3d p(0.0, 0.0, 0.6);
    drawn.wrench.setForce(view3d::DrawnForce{p, {0.0, 0.0, -10.0}, true, 0.0});
    drawn.wrench.draw(drawn.scene);
    EXPECT_FALSE(drawn.wrench.forceTail());
    view3d::ArmLink link;
    link.length_m = 0.6;
    link.radius_m = 0.02;
    drawn.scene.setArmLinks(std::array{link});
    drawn.wrench.draw(drawn.scene);
    ASSERT_TRUE(drawn.wrench.forceTail());
    EXPECT_GE(drawn.wrench.forceRange_N(drawn.scene), 10.0);
    EXPECT_GT(drawn.wrench.forceTail()->z(), p.z()) << "it presses down on its head";
    // What is computed from the torques is drawn beside what an array measures.
    drawn.wrench.setForce(view3d::DrawnForce{p, {0.0, 0.0, -10.0}});
    drawn.wrench.draw(drawn.scene);
    EXPECT_FALSE(drawn.wrench.forceTail());
}

TEST(WrenchPart, theMomentTurnsTheWayItsArrowShows) {
    Drawn drawn;
    drawn.show(slanted());
    ASSERT_TRUE(drawn.wrench.momentHead());
    const TactileFeatures& features = drawn.scene.snapshot().features;
    const Eigen::Vector3d centre(*features.cocX_m, *features.cocY_m, drawn.scene.sensorSize().tile_m);
    const Eigen::Vector3d out = *drawn.wrench.momentHead() - centre;
    const Eigen::Vector3d moment_Nm = *view3d::momentOf_Nm(features);
    // Begun at the normal, a turn about the moment leads towards M x z.
    EXPECT_GT(out.dot(moment_Nm.cross(Eigen::Vector3d::UnitZ())), 0.0);
    EXPECT_NEAR(out.dot(moment_Nm.normalized()), 0.0, 1e-12);
    EXPECT_GT(out.z(), 0.0) << "not hidden by the array";
    EXPECT_NEAR(drawn.wrench.moment_Nm(), moment_Nm.norm(), 1e-15);
    EXPECT_GE(drawn.wrench.momentRange_Nm(), moment_Nm.norm());
}

TEST(WrenchPart, aMomentThatIsNotKnownIsNotDrawn) {
    Drawn drawn;
    pipeline::TouchSnapshot snapshot = slanted();
    snapshot.loadUnit = std::string("counts");
    drawn.wrench.setForce(view3d::DrawnForce{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
    drawn.show(snapshot);
    EXPECT_FALSE(drawn.wrench.momentHead()) << "loads that are no forces";
    EXPECT_FALSE(drawn.wrench.forceTail());
    drawn.show(slanted(2));
    EXPECT_TRUE(drawn.wrench.momentHead());
    drawn.wrench.setArrayBent(true);
    drawn.wrench.draw(drawn.scene);
    EXPECT_FALSE(drawn.wrench.momentHead());
    drawn.wrench.setArrayBent(false);
    drawn.scene.setSurface(view3d::Surface::cylinder);
    drawn.wrench.draw(drawn.scene);
    EXPECT_FALSE(drawn.wrench.momentHead()) << "drawn elsewhere than it acts";
}

namespace {

view3d::JointDial dialAt(double angle_rad) {
    return {QStringLiteral("elbow"), Eigen::Isometry3d::Identity(), angle_rad, -1.0, 2.0, 0.03};
}

} // namespace

TEST(LimitPart, onlyAJointNearItsEndHasADial) {
    view3d::LimitPart limits;
    limits.applyColours(view3d::SceneColours(base::designedPalette(true)));
    EXPECT_FALSE(limits.set(std::vector{dialAt(0.0)}));
    EXPECT_TRUE(limits.marks().empty());
    EXPECT_TRUE(limits.set(std::vector{dialAt(1.9)}));
    ASSERT_EQ(limits.marks().size(), 1U);
    EXPECT_FALSE(limits.marks()[0].isAtEnd);
    // The label is outside of the dial, at the present angle.
    const Eigen::Vector3d& label = limits.marks()[0].p_World_Label;
    EXPECT_NEAR(std::atan2(label.y(), label.x()), 1.9, 1e-12);
    EXPECT_FALSE(limits.set(std::vector{dialAt(1.9)})) << "nothing to draw anew";
    EXPECT_TRUE(limits.set(std::vector{dialAt(2.0)}));
    EXPECT_TRUE(limits.marks()[0].isAtEnd);
    EXPECT_NE(limits.marks()[0].colour, view3d::SceneColours(base::designedPalette(true)).nearLimit);
    EXPECT_TRUE(limits.set({}));
    EXPECT_TRUE(limits.marks().empty());
}

TEST(LimitPart, aDialThatCannotBeDrawnIsLeftOut) {
    view3d::LimitPart limits;
    view3d::JointDial dial = dialAt(1.95);
    dial.radius_m = 0.0;
    EXPECT_FALSE(limits.set(std::vector{dial}));
    dial = dialAt(1.95);
    dial.X_World_Joint.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(limits.set(std::vector{dial}));
    EXPECT_TRUE(limits.marks().empty());
}
