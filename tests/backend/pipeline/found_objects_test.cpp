// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/found_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace teleta::pipeline {

namespace {

TouchRecord touchAt(double x_m, double y_m) {
    TouchRecord touch;
    touch.located = true;
    touch.p_Base_Contact_m = {x_m, y_m, -0.3};
    touch.contactType = contact::ContactType::edge;
    return touch;
}

TouchRecord touchOf(double x_m, double y_m, std::optional<double> value, double lower,
                    std::optional<double> upper) {
    TouchRecord touch = touchAt(x_m, y_m);
    touch.stiffness.emplace();
    touch.stiffness->object = {
        .value_NPerM = value, .se_NPerM = {}, .lower95_NPerM = lower, .upper95_NPerM = upper};
    return touch;
}

} // namespace

TEST(FoundObjects, belongToTheNearestContactWithinFiveCentimetres) {
    FoundObjects found;
    EXPECT_EQ(found.add(touchAt(0.0, 0.0))->number, 1U);
    EXPECT_EQ(found.add(touchAt(0.049, 0.0))->number, 1U);
    EXPECT_EQ(found.add(touchAt(0.098, 0.0))->number, 1U); // from contact to contact
    EXPECT_EQ(found.add(touchAt(0.149, 0.0))->number, 2U);
    EXPECT_EQ(found.add(touchAt(0.12, 0.0))->number, 1U); // 22 mm from the first, 29 mm from the second
    ASSERT_EQ(found.objects().size(), 2U);
    EXPECT_EQ(found.objects()[0].touches, 4U);
    EXPECT_NEAR(found.objects()[0].p_Base_Centre_m.x(), (0.049 + 0.098 + 0.12) / 4.0, 1e-15);
    EXPECT_EQ(found.objects()[0].contact, contact::ContactType::edge);
}

TEST(FoundObjects, haveAContourAndAShapeOfTheirOwn) {
    FoundObjects found;
    for (int i = 0; i < 12; ++i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / 12;
        found.add(touchAt(0.03 * std::cos(angle_rad), 0.03 * std::sin(angle_rad)));
        found.add(touchAt(0.5, 0.004 * i)); // in between, on another one
    }
    ASSERT_EQ(found.objects().size(), 2U);
    EXPECT_EQ(found.objects()[0].recognition->shape, contour::Shape::circle);
    EXPECT_EQ(found.objects()[1].recognition->shape, contour::Shape::line);
    EXPECT_EQ(found.objects()[0].contour.points_m.size(), 12U);
    EXPECT_EQ(found.objects()[0].contour.points_m.front().x(), 0.03);
    EXPECT_NEAR(found.objects()[0].contour.height_m, -0.3, 1e-15);
    EXPECT_EQ(found.contour().points_m.size(), 12U); // of the one touched last
    EXPECT_EQ(found.contour().points_m.front().x(), 0.5);
    EXPECT_EQ(found.contour().revision, 24U);
}

TEST(FoundObjects, tellTheMedianStiffnessBetweenTheMediansOfItsEnds) {
    FoundObjects found;
    found.add(touchOf(0.00, 0.0, 1000.0, 900.0, 1100.0));
    found.add(touchOf(0.01, 0.0, 1200.0, 1000.0, 1500.0));
    found.add(touchOf(0.02, 0.0, 14000.0, 13000.0, 16000.0)); // slid off a corner
    found.add(touchAt(0.03, 0.0));                            // tells no stiffness
    const FoundObject& object = found.objects().at(0);
    EXPECT_EQ(object.stiffness->value_NPerM, 1200.0);
    EXPECT_EQ(object.stiffness->lower95_NPerM, 1000.0);
    EXPECT_EQ(object.stiffness->upper95_NPerM, 1500.0);
    EXPECT_EQ(object.material, stiffness::Material::rubberSponge);
    EXPECT_EQ(object.touches, 4U);
}

TEST(FoundObjects, areOnlyBoundedWhenMostTouchesDoNotTellThemFromRigid) {
    FoundObjects found;
    found.add(touchOf(0.00, 0.0, {}, 20000.0, {}));
    found.add(touchOf(0.01, 0.0, {}, 18000.0, {}));
    found.add(touchOf(0.02, 0.0, 30000.0, 19000.0, {}));
    const FoundObject& object = found.objects().at(0);
    EXPECT_FALSE(object.stiffness->value_NPerM);
    EXPECT_EQ(object.stiffness->lower95_NPerM, 19000.0);
    EXPECT_FALSE(object.stiffness->upper95_NPerM);
    EXPECT_EQ(object.material, stiffness::Material::metal);
}

TEST(FoundObjects, areNotMetalForABoundThatAllowsWhatAnotherTouchTold) {
    FoundObjects found;
    found.add(touchOf(0.00, 0.0, {}, 600.0, {}));
    EXPECT_EQ(found.objects().at(0).material, stiffness::Material::metal) << "not told from rigid";
    found.add(touchOf(0.01, 0.0, 1300.0, 1200.0, 1400.0));
    EXPECT_EQ(found.objects().at(0).stiffness->value_NPerM, 1300.0);
    EXPECT_EQ(found.objects().at(0).stiffness->upper95_NPerM, 1400.0);
    EXPECT_EQ(found.objects().at(0).material, stiffness::Material::rubberSponge);
    // One that contradicts it counts.
    found.add(touchOf(0.02, 0.0, {}, 9000.0, {}));
    found.add(touchOf(0.03, 0.0, {}, 9500.0, {}));
    EXPECT_EQ(found.objects().at(0).material, stiffness::Material::metal);
}

TEST(FoundObjects, areReplacedWhenTheSamePointHasAnotherStiffness) {
    FoundObjects found;
    found.add(touchOf(0.0, 0.0, 282.0, 270.0, 290.0));
    EXPECT_EQ(found.add(touchOf(0.004, 0.0, 285.0, 275.0, 300.0))->number, 1U);
    EXPECT_EQ(found.add(touchOf(0.02, 0.0, 500.0, 480.0, 520.0))->number, 1U); // another point of it
    EXPECT_EQ(found.add(touchOf(0.0, 0.0, 1326.0, 1300.0, 1350.0))->number, 2U);
    EXPECT_EQ(found.add(touchOf(0.0, 0.0, 1320.0, 1290.0, 1340.0))->number, 2U); // the first one is gone
}

TEST(FoundObjects, beginAnewOnCommandAndIgnoreWhatHasNoPlace) {
    FoundObjects found;
    EXPECT_EQ(found.add(TouchRecord{}), nullptr);
    EXPECT_EQ(found.add(touchAt(std::numeric_limits<double>::quiet_NaN(), 0.0)), nullptr);
    EXPECT_TRUE(found.objects().empty());
    found.closeAll();
    EXPECT_EQ(found.contour().revision, 0U);
    found.add(touchAt(0.0, 0.0));
    found.closeAll();
    EXPECT_TRUE(found.contour().points_m.empty());
    EXPECT_EQ(found.contour().revision, 2U);
    EXPECT_EQ(found.add(touchAt(0.0, 0.0))->number, 2U);
    EXPECT_EQ(found.objects()[0].touches, 1U);
}

} // namespace teleta::pipeline
