// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/frame_analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace teleta::contact {
namespace {

using core::ArrayLayout;
using core::TaxelLayout;
using core::TaxelPlace;
using core::TaxelPlaces;

/// The places of a grid, taxel by taxel.
std::shared_ptr<const TaxelPlaces> placesOf(const ArrayLayout& grid) {
    std::vector<TaxelPlace> places;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            places.push_back({grid.x_m(column), grid.y_m(row)});
    return std::make_shared<const TaxelPlaces>(std::move(places));
}

AnalysisSettings withThreshold(double threshold_N) {
    AnalysisSettings settings;
    settings.features.threshold_N = threshold_N;
    settings.segmentation.threshold_N = threshold_N;
    return settings;
}

TaxelFrame analysed(const TaxelLayout& layout, const std::vector<float>& raw,
                    const AnalysisSettings& settings = withThreshold(0.1)) {
    FrameAnalysis analysis(layout, settings);
    TaxelFrame frame;
    frame.layout = layout;
    analysis.analyse(raw, 0.0, frame);
    frame.labels.assign(analysis.labels().begin(), analysis.labels().end());
    return frame;
}

/// Cells of 4 mm x 10 mm.
const ArrayLayout kRectangles{3, 4, 0.004, 0.010};

TEST(FrameAnalysis, placesContactsOnCellsThatAreNotSquare) {
    std::vector<float> loads(12, 0.0F);
    loads[5] = 1.0F;  // row 1, column 1
    loads[6] = 3.0F;  // row 1, column 2
    loads[10] = 4.0F; // row 2, column 2
    const TaxelFrame frame = analysed(kRectangles, loads);
    ASSERT_EQ(frame.contacts.size(), 1U);
    // x of the columns: -6, -2, 2, 6 mm; y of the rows: -10, 0, 10 mm.
    EXPECT_NEAR(frame.contacts[0].x_m, (-0.002 + 7.0 * 0.002) / 8.0, 1e-15);
    EXPECT_NEAR(frame.contacts[0].y_m, 4.0 * 0.010 / 8.0, 1e-15);
    EXPECT_NEAR(frame.contacts[0].area_m2, 3.0 * 4e-5, 1e-18);
    EXPECT_NEAR(*frame.features.copY_m, 0.005, 1e-15);
    EXPECT_NEAR(*frame.features.cocX_m, 0.002 / 3.0, 1e-15);
    EXPECT_NEAR(*frame.features.cocY_m, 0.010 / 3.0, 1e-15);
    // Covariance over the three taxels: xx = (8/3) 4 mm^2, yy = (1/3) 100 mm^2, xy = (1/3) (4 x 10) mm^2 / 2.
    const double xx = 16e-6 / 3.0;
    const double yy = 100e-6 / 3.0;
    const double xy = 20e-6 / 3.0;
    const double root = std::hypot(xx - yy, 2.0 * xy);
    EXPECT_NEAR(*frame.features.lambda1_m2, 0.5 * (xx + yy + root), 1e-15);
    EXPECT_NEAR(*frame.features.lambda2_m2, 0.5 * (xx + yy - root), 1e-15);
    EXPECT_NEAR(*frame.features.alphaZ_rad, 0.5 * std::atan2(2.0 * xy, xx - yy), 1e-12);
}

TEST(FrameAnalysis, findsTheSameOnAGridAndOnItsPlaces) {
    for (const double pitchY_m : {0.004, 0.0075}) {
        const ArrayLayout grid{7, 9, 0.004, pitchY_m};
        std::vector<float> loads(grid.taxels(), 0.0F);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const double first = 2.0 - std::hypot(row - 1.5, column - 1.8);
                const double second = 2.4 - std::hypot(row - 4.8, column - 6.3);
                loads[static_cast<std::size_t>(row * grid.columns + column)] =
                    static_cast<float>(std::max({0.0, first, second}));
            }
        for (const auto mode : {OrientationMode::binarised, OrientationMode::weighted}) {
            AnalysisSettings settings = withThreshold(0.2);
            settings.features.orientation = mode;
            const TaxelFrame onGrid = analysed(grid, loads, settings);
            const TaxelFrame atPlaces = analysed(TaxelLayout(placesOf(grid)), loads, settings);
            ASSERT_EQ(onGrid.contacts.size(), 2U);
            ASSERT_EQ(atPlaces.contacts.size(), 2U);
            EXPECT_EQ(atPlaces.labels, onGrid.labels);
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_EQ(atPlaces.contacts[i].id, onGrid.contacts[i].id);
                EXPECT_EQ(atPlaces.contacts[i].taxels, onGrid.contacts[i].taxels);
                EXPECT_NEAR(atPlaces.contacts[i].force_N, onGrid.contacts[i].force_N, 1e-12);
                EXPECT_NEAR(atPlaces.contacts[i].peak_N, onGrid.contacts[i].peak_N, 0.0);
                EXPECT_NEAR(atPlaces.contacts[i].x_m, onGrid.contacts[i].x_m, 1e-15);
                EXPECT_NEAR(atPlaces.contacts[i].y_m, onGrid.contacts[i].y_m, 1e-15);
            }
            const TactileFeatures& a = atPlaces.features;
            const TactileFeatures& b = onGrid.features;
            EXPECT_EQ(a.type, b.type);
            EXPECT_EQ(a.active, b.active);
            EXPECT_NEAR(a.force_N, b.force_N, 1e-12);
            EXPECT_NEAR(*a.copX_m, *b.copX_m, 1e-15);
            EXPECT_NEAR(*a.copY_m, *b.copY_m, 1e-15);
            EXPECT_NEAR(*a.cocX_m, *b.cocX_m, 1e-15);
            EXPECT_NEAR(*a.dzmpX_m, *b.dzmpX_m, 1e-15);
            EXPECT_NEAR(*a.lambda1_m2, *b.lambda1_m2, 1e-15);
            EXPECT_NEAR(*a.lambda2_m2, *b.lambda2_m2, 1e-15);
            EXPECT_NEAR(*a.alphaZ_rad, *b.alphaZ_rad, 1e-9);
        }
    }
}

TEST(FrameAnalysis, takesTheAreaOfASquareGridFromItsPlaces) {
    const ArrayLayout grid{3, 3, 0.004};
    const std::vector<float> loads(9, 1.0F);
    const TaxelFrame frame = analysed(TaxelLayout(placesOf(grid)), loads);
    ASSERT_EQ(frame.contacts.size(), 1U);
    EXPECT_NEAR(frame.contacts[0].area_m2, 9.0 * 0.004 * 0.004, 1e-15);
}

/// Two taxels, 10 mm apart in x, with forces on the sensor.
TEST(FrameAnalysis, sumsTheShearOfVectors) {
    const std::vector<float> raw{0.0F, 1.0F,  -1.0F,  // pushed along y
                                 0.5F, -2.0F, -3.0F}; // and back
    for (const TaxelLayout& layout :
         {TaxelLayout(ArrayLayout{1, 2, 0.010}, 3), TaxelLayout(placesOf({1, 2, 0.010}), 3)}) {
        const TaxelFrame frame = analysed(layout, raw);
        EXPECT_EQ(frame.load_N, (std::vector<float>{1.0F, 3.0F}));
        EXPECT_EQ(frame.shearX_N, (std::vector<float>{0.0F, 0.5F}));
        EXPECT_EQ(frame.shearY_N, (std::vector<float>{1.0F, -2.0F}));
        ASSERT_EQ(frame.contacts.size(), 1U);
        // CoP at x = (-5 + 3 x 5) / 4 = 2.5 mm: -7.5 mm x 1 N + 2.5 mm x -2 N.
        EXPECT_NEAR(*frame.features.copX_m, 0.0025, 1e-15);
        for (const auto& shear : {frame.contacts[0].shear, frame.features.shear}) {
            ASSERT_TRUE(shear);
            EXPECT_NEAR(shear->x_N, 0.5, 1e-15);
            EXPECT_NEAR(shear->y_N, -1.0, 1e-15);
            EXPECT_NEAR(shear->momentZ_Nm, -0.0075 - 0.005, 1e-15);
            EXPECT_NEAR(shear->friction, std::sqrt(1.25) / 4.0, 1e-15);
        }
    }
}

/// A disc that turns about z: shear at a right angle to the radius. Its moment is the sum of r times shear.
TEST(FrameAnalysis, knowsTheTorsionOfATurningPress) {
    const ArrayLayout grid{5, 5, 0.004, 0.006};
    std::vector<float> raw;
    double moment_Nm = 0.0;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) {
            const double x_m = grid.x_m(column);
            const double y_m = grid.y_m(row);
            raw.insert(raw.end(), {static_cast<float>(-50.0 * y_m), static_cast<float>(50.0 * x_m), -1.0F});
            moment_Nm += 50.0 * (x_m * x_m + y_m * y_m);
        }
    const TaxelFrame frame = analysed(TaxelLayout(grid, 3), raw);
    ASSERT_EQ(frame.contacts.size(), 1U);
    ASSERT_TRUE(frame.contacts[0].shear);
    EXPECT_NEAR(frame.contacts[0].shear->momentZ_Nm, moment_Nm, 1e-8);
    EXPECT_NEAR(frame.contacts[0].shear->friction, 0.0, 1e-8);
}

TEST(FrameAnalysis, sumsTheShearOfEachContactAlone) {
    const TaxelLayout layout(ArrayLayout{1, 5, 0.004}, 3);
    const std::vector<float> raw{0.1F, 0, -1, 0, 0.2F, -0.1F, 0, 9, 0, 0, 0, 0, 0.3F, 0.4F, -2};
    AnalysisSettings settings = withThreshold(0.5);
    settings.features.range = MomentRange::active;
    const TaxelFrame frame = analysed(layout, raw, settings);
    ASSERT_EQ(frame.contacts.size(), 2U);
    EXPECT_NEAR(frame.contacts[0].shear->friction, 0.25, 1e-7);
    EXPECT_NEAR(frame.contacts[0].shear->momentZ_Nm, 0.0, 1e-15) << "one taxel is its own centre";
    EXPECT_NEAR(frame.contacts[1].shear->x_N, 0.1, 1e-7);
    EXPECT_NEAR(frame.features.shear->y_N, 0.4, 1e-7) << "active taxels only";
    settings.features.range = MomentRange::image;
    // Of a friction ratio it is the numerator: a taxel that nothing presses does not belong to it.
    EXPECT_NEAR(analysed(layout, raw, settings).features.shear->y_N, 0.6, 1e-6);
}

TEST(FrameAnalysis, tellsNoShearOfLoadsOrWithoutAContact) {
    const TaxelFrame loads = analysed(ArrayLayout{1, 2, 0.004}, {1.0F, 2.0F});
    EXPECT_FALSE(loads.contacts[0].shear);
    EXPECT_FALSE(loads.features.shear);
    EXPECT_TRUE(loads.shearX_N.empty());
    // A pull is no load, and the shear beside it is that of no contact.
    const TaxelFrame pulled = analysed(TaxelLayout(ArrayLayout{1, 1, 0.004}, 3), {1.0F, 1.0F, 5.0F});
    EXPECT_EQ(pulled.load_N, std::vector<float>{0.0F});
    EXPECT_TRUE(pulled.contacts.empty());
    EXPECT_FALSE(pulled.features.copX_m);
    EXPECT_FALSE(pulled.features.shear);
}

TEST(FrameAnalysis, tareGainAndSignActOnAllComponents) {
    AnalysisSettings settings = withThreshold(0.1);
    settings.conditioning.tare = {1.0F, 2.0F, 3.0F};
    settings.conditioning.gain = 0.5;
    const TaxelLayout one(ArrayLayout{1, 1, 0.004}, 3);
    TaxelFrame frame = analysed(one, {3.0F, 1.0F, -1.0F}, settings);
    EXPECT_FLOAT_EQ(frame.load_N[0], 2.0F);
    EXPECT_FLOAT_EQ(frame.shearX_N[0], 1.0F);
    EXPECT_FLOAT_EQ(frame.shearY_N[0], -0.5F);
    settings.conditioning.inverted = true; // the force that the sensor exerts
    settings.conditioning.taxelGain = {2.0F};
    frame = analysed(one, {3.0F, 1.0F, 7.0F}, settings);
    EXPECT_FLOAT_EQ(frame.load_N[0], 4.0F);
    EXPECT_FLOAT_EQ(frame.shearX_N[0], -2.0F);
    EXPECT_FLOAT_EQ(frame.shearY_N[0], 1.0F);
}

/// A taxel on the side of a fingertip looks along x. A force of 2 N into it and 1 N along z slides.
TEST(FrameAnalysis, pressesAlongTheNormalOfAPlace) {
    const auto places =
        std::make_shared<const TaxelPlaces>(std::vector<TaxelPlace>{{0.0, 0.0, 0.0, {1.0, 0.0, 0.0}}});
    const TaxelFrame frame = analysed(TaxelLayout(places, 3), {-2.0F, 0.5F, 1.0F});
    EXPECT_FLOAT_EQ(frame.load_N[0], 2.0F);
    EXPECT_FLOAT_EQ(frame.shearX_N[0], 0.0F);
    EXPECT_FLOAT_EQ(frame.shearY_N[0], 0.5F);
}

TEST(FrameAnalysis, leavesOutTaxelsThatTellNoNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const TaxelLayout layout(ArrayLayout{1, 3, 0.004}, 3);
    const TaxelFrame frame = analysed(layout, {0, 0, -1, nan, 5, -5, 0, 0, -1});
    EXPECT_EQ(frame.dead, (std::vector<std::uint8_t>{0, 1, 0}));
    EXPECT_EQ(frame.features.dead, 1);
    EXPECT_EQ(frame.contacts.size(), 2U);
    EXPECT_NEAR(frame.features.shear->y_N, 0.0, 0.0);
}

TEST(FrameAnalysis, countsNoPlaceWithoutATaxelAsDead) {
    for (const int components : {1, 3}) {
        TaxelLayout layout(ArrayLayout{1, 3, 0.004}, components);
        layout.setAbsent({0, 1, 0});
        const std::vector<float> raw = components == 1 ? std::vector<float>{1.0F, 7.0F, 1.0F}
                                                       : std::vector<float>{0, 0, -1, 0, 0, -7, 0, 0, -1};
        const TaxelFrame frame = analysed(layout, raw);
        EXPECT_EQ(frame.features.dead, 0);
        EXPECT_EQ(frame.contacts.size(), 2U) << "what is between them is no taxel";
        EXPECT_NEAR(frame.features.force_N, 2.0, 1e-12);
    }
}

TEST(FrameAnalysis, findsNothingWhereAllTaxelsAreDead) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const TaxelLayout& layout :
         {TaxelLayout(ArrayLayout{1, 2, 0.004}, 3), TaxelLayout(placesOf({1, 2, 0.004}), 3)}) {
        const TaxelFrame frame = analysed(layout, std::vector<float>(6, nan));
        EXPECT_TRUE(frame.contacts.empty());
        EXPECT_EQ(frame.features.dead, 2);
        EXPECT_FALSE(frame.features.copX_m);
        EXPECT_EQ(frame.features.type, ContactType::none);
    }
}

TEST(FrameAnalysis, takesASingleTaxelAndALineOfTaxels) {
    const auto one = std::make_shared<const TaxelPlaces>(std::vector<TaxelPlace>{{0.003, -0.001}});
    const TaxelFrame single = analysed(TaxelLayout(one), {2.0F});
    ASSERT_EQ(single.contacts.size(), 1U);
    EXPECT_DOUBLE_EQ(single.contacts[0].x_m, 0.003);
    EXPECT_EQ(single.features.type, ContactType::point);
    EXPECT_FALSE(single.features.lambda1_m2);

    const auto line = std::make_shared<const TaxelPlaces>(
        std::vector<TaxelPlace>{{0.0, 0.0}, {0.003, 0.004}, {0.006, 0.008}});
    const TaxelFrame pressed = analysed(TaxelLayout(line), {1.0F, 1.0F, 1.0F});
    ASSERT_EQ(pressed.contacts.size(), 1U);
    EXPECT_EQ(pressed.features.type, ContactType::edge);
    EXPECT_NEAR(*pressed.features.lambda1_m2, 25e-6, 1e-15); // (-5, 0, 5) mm
    EXPECT_NEAR(*pressed.features.lambda2_m2, 0.0, 1e-18);
    EXPECT_NEAR(*pressed.features.alphaZ_rad, std::atan2(4.0, 3.0), 1e-12);
}

/// Two summits with a pass between them that is 0.6 of the lower one.
TEST(FrameAnalysis, mergesSummitsThatRiseTooLittle) {
    const auto line = placesOf({1, 5, 0.004});
    const std::vector<float> loads{1.0F, 0.8F, 0.6F, 0.9F, 1.0F};
    AnalysisSettings settings = withThreshold(0.1);
    settings.segmentation.noiseHeight = 0.39;
    EXPECT_EQ(analysed(TaxelLayout(line), loads, settings).contacts.size(), 2U);
    settings.segmentation.noiseHeight = 0.41;
    EXPECT_EQ(analysed(TaxelLayout(line), loads, settings).contacts.size(), 1U);
    settings.segmentation.noiseHeight = 0.0;
    settings.segmentation.minimumTaxels = 3;
    EXPECT_EQ(analysed(TaxelLayout(line), loads, settings).contacts.size(), 1U);
}

TEST(FrameAnalysis, contactsKeepTheirIdentityBetweenFrames) {
    const TaxelLayout layout(placesOf({1, 6, 0.010}), 3);
    FrameAnalysis analysis(layout, withThreshold(0.5));
    TaxelFrame frame;
    frame.layout = layout;
    std::vector<float> raw(18, 0.0F);
    raw[2] = -2.0F;  // taxel 0
    raw[14] = -1.0F; // taxel 4
    analysis.analyse(raw, 0.0, frame);
    ASSERT_EQ(frame.contacts.size(), 2U);
    const int first = frame.contacts[0].id;
    raw[2] = -1.0F;
    raw[14] = 0.0F;
    raw[17] = -2.0F; // moved to taxel 5, and is now the heavier one
    analysis.analyse(raw, 0.01, frame);
    ASSERT_EQ(frame.contacts.size(), 2U);
    EXPECT_EQ(frame.contacts[1].id, first);
}

} // namespace
} // namespace teleta::contact
