// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/summit.h"
#include "backend/core/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

using namespace teleta::contact;
using teleta::core::ArrayLayout;

namespace {

const ArrayLayout kArray{.rows = 6, .columns = 14, .pitchX_m = 0.0034};

/// load = peak (1 - r^2 / radius^2) at the taxels within the radius.
std::vector<float> paraboloid(double x_m, double y_m, double radius_m, double peak_N) {
    std::vector<float> load_N;
    for (int row = 0; row < kArray.rows; ++row)
        for (int column = 0; column < kArray.columns; ++column) {
            const double r = std::hypot(kArray.x_m(column) - x_m, kArray.y_m(row) - y_m) / radius_m;
            load_N.push_back(static_cast<float>(std::max(0.0, peak_N * (1.0 - r * r))));
        }
    return load_N;
}

constexpr double kThreshold_N = 0.05;

const ArrayLayout kRow{.rows = 1, .columns = 7, .pitchX_m = 0.02};
const ArrayLayout kColumn{.rows = 7, .columns = 1, .pitchX_m = 0.02};

/// An even pressure of 2 N a taxel from one place to another, in taxels.
std::vector<float> evenPressure(double from, double to) {
    std::vector<float> load_N;
    for (int i = 0; i < 7; ++i)
        load_N.push_back(
            static_cast<float>(2.0 * std::max(0.0, std::min(to, i + 0.5) - std::max(from, i - 0.5))));
    return load_N;
}

} // namespace

TEST(Summit, ofAParaboloidIsExactWhereverItIs) {
    for (const double x_m : {-0.011, 0.0, 0.0042})
        for (const double y_m : {-0.003, 0.0013, 0.006}) {
            const auto summit = summitOf(paraboloid(x_m, y_m, 0.009, 2.0), kArray, kThreshold_N);
            ASSERT_TRUE(summit);
            EXPECT_NEAR(summit->x_m, x_m, 1e-8);
            EXPECT_NEAR(summit->y_m, y_m, 1e-8);
            EXPECT_NEAR(summit->peak_N, 2.0, 1e-6);
        }
}

TEST(Summit, isNotPulledInwardByTheBorderOfTheArray) {
    // The outermost taxels are at x = 22.1 mm: half of the contact is beyond.
    const auto summit = summitOf(paraboloid(0.0215, 0.0, 0.009, 2.0), kArray, kThreshold_N);
    ASSERT_TRUE(summit);
    EXPECT_NEAR(summit->x_m, 0.0215, 1e-8);
}

TEST(Summit, staysWhereItIsWhateverTheUnitOfTheLoads) {
    for (const double scale : {1e-12, 1e-3, 1e12}) {
        const auto summit = summitOf(paraboloid(0.002, -0.001, 0.009, 2.0 * scale), kArray, 0.05 * scale);
        ASSERT_TRUE(summit) << scale;
        EXPECT_NEAR(summit->x_m, 0.002, 1e-8);
        EXPECT_NEAR(summit->peak_N / scale, 2.0, 1e-6);
    }
}

TEST(Summit, isMirroredWithTheFrame) {
    const auto right = summitOf(paraboloid(0.0063, 0.001, 0.011, 1.5), kArray, kThreshold_N);
    const auto left = summitOf(paraboloid(-0.0063, 0.001, 0.011, 1.5), kArray, kThreshold_N);
    ASSERT_TRUE(right && left);
    EXPECT_NEAR(right->x_m, -left->x_m, 1e-12);
    EXPECT_NEAR(right->y_m, left->y_m, 1e-12);
}

TEST(Summit, isNoneWhereTheLoadsHaveNone) {
    const std::vector<float> empty(kArray.taxels(), 0.0F);
    EXPECT_FALSE(summitOf(empty, kArray, kThreshold_N));

    std::vector<float> few = empty;
    few[20] = few[21] = few[34] = few[35] = 1.0F;
    EXPECT_FALSE(summitOf(few, kArray, kThreshold_N)) << "four taxels";

    std::vector<float> line = empty;
    for (std::size_t column = 3; column < 10; ++column)
        line[2 * 14 + column] = 1.0F + static_cast<float>(column % 3);
    EXPECT_FALSE(summitOf(line, kArray, kThreshold_N)) << "all in one row";

    std::vector<float> diagonal = empty;
    for (std::size_t i = 0; i < 6; ++i)
        diagonal[i * 14 + i] = 1.0F + static_cast<float>(i % 2);
    EXPECT_FALSE(summitOf(diagonal, kArray, kThreshold_N)) << "all in one line";

    const std::vector<float> plateau(kArray.taxels(), 2.5F);
    EXPECT_FALSE(summitOf(plateau, kArray, kThreshold_N)) << "a saturated frame";

    std::vector<float> bowl = paraboloid(0.0, 0.0, 0.05, 1.0);
    for (float& load : bowl)
        load = 1.5F - load;
    EXPECT_FALSE(summitOf(bowl, kArray, kThreshold_N)) << "the middle is lowest";

    std::vector<float> slope(kArray.taxels());
    for (std::size_t i = 0; i < slope.size(); ++i)
        slope[i] = 1.0F + 0.1F * static_cast<float>(i % 14);
    EXPECT_FALSE(summitOf(slope, kArray, kThreshold_N)) << "it rises beyond the array";
}

TEST(Summit, ofAStripIsTheMiddleOfAnEvenPressure) {
    for (const double centre : {2.0, 2.4, 3.0, 3.3, 3.9})
        for (const double width : {2.0, 2.6, 3.0}) {
            const auto load_N = evenPressure(centre - 0.5 * width, centre + 0.5 * width);
            const auto row = summitOf(load_N, kRow, kThreshold_N, {}, 0.01);
            ASSERT_TRUE(row);
            EXPECT_NEAR(row->x_m, (centre - 3.0) * 0.02, 1e-8);
            EXPECT_EQ(row->y_m, 0.0);
            EXPECT_NEAR(row->peak_N, 2.0, 1e-6);
            EXPECT_TRUE(row->xSe_m);
            EXPECT_FALSE(row->ySe_m) << "a row does not tell the place across";
            const auto column = summitOf(load_N, kColumn, kThreshold_N, {}, 0.01);
            ASSERT_TRUE(column);
            EXPECT_EQ(column->x_m, 0.0);
            EXPECT_NEAR(column->y_m, row->x_m, 1e-15);
            EXPECT_EQ(column->ySe_m, row->xSe_m);
        }
}

TEST(Summit, ofAStripTakesLoadsBelowTheThresholdAtItsEdges) {
    // The patch reaches 0.4 taxels over the left neighbour, 0.8 N, and 0.2 over the right one, 0.4 N.
    const auto summit = summitOf(evenPressure(2.1, 4.7), kRow, 1.0);
    ASSERT_TRUE(summit);
    EXPECT_NEAR(summit->x_m, 0.4 * 0.02, 1e-8);
}

TEST(Summit, ofAStripIsEmptyWhereAnEdgeIsNotSeen) {
    EXPECT_FALSE(summitOf(evenPressure(-0.5, 1.2), kRow, kThreshold_N)) << "from the end of the strip on";
    EXPECT_FALSE(summitOf(evenPressure(4.8, 6.5), kRow, kThreshold_N));
    EXPECT_TRUE(summitOf(evenPressure(0.1, 1.9), kRow, kThreshold_N)) << "its edge is on the first taxel";
    EXPECT_FALSE(summitOf(std::vector<float>(7, 2.0F), kRow, kThreshold_N)) << "a saturated frame";
    EXPECT_FALSE(summitOf(std::vector<float>(7, 0.0F), kRow, kThreshold_N));
    EXPECT_FALSE(summitOf(std::vector<float>{2.0F}, {.rows = 1, .columns = 1}, kThreshold_N));

    const std::vector<float> load_N = evenPressure(2.0, 4.0);
    std::vector<std::uint8_t> dead(7, 0);
    dead[0] = 1;
    EXPECT_TRUE(summitOf(load_N, kRow, kThreshold_N, dead));
    dead[1] = 1;
    EXPECT_FALSE(summitOf(load_N, kRow, kThreshold_N, dead)) << "the edge may be on a dead taxel";
}

TEST(Summit, ofAStripWithOneActiveTaxelIsThatTaxel) {
    std::vector<float> load_N(7, 0.0F);
    load_N[4] = 1.0F;
    const auto summit = summitOf(load_N, kRow, kThreshold_N, {}, 0.001);
    ASSERT_TRUE(summit);
    EXPECT_NEAR(summit->x_m, 0.02, 1e-15);
    EXPECT_GT(*summit->xSe_m, 0.02 / std::sqrt(12.0)) << "it may be anywhere on the taxel";
}

TEST(Summit, ofEachContactOfAStripIsItsOwn) {
    const ArrayLayout strip{.rows = 1, .columns = 14, .pitchX_m = 0.01};
    // Two even pressures: 1.2 to 3.3, and 8.5 to 11.1.
    const std::vector<float> load_N{0, 0.3F * 2, 2, 0.8F * 2, 0, 0, 0, 0, 0, 1, 1, 0.6F, 0, 0};
    teleta::contact::ContactSegmenter segmenter(strip, {.threshold_N = kThreshold_N});
    const auto contacts = segmenter.segment(load_N);
    ASSERT_EQ(contacts.size(), 2U);
    const auto first = summitOf(load_N, strip, segmenter, contacts[0]);
    const auto second = summitOf(load_N, strip, segmenter, contacts[1]);
    ASSERT_TRUE(first && second);
    EXPECT_NEAR(first->x_m, (0.5 * (1.2 + 3.3) - 6.5) * 0.01, 1e-8);
    EXPECT_NEAR(second->x_m, (0.5 * (8.5 + 11.1) - 6.5) * 0.01, 1e-8);
}

TEST(Summit, ofEachContactOfAnArrayIsItsOwn) {
    std::vector<float> load_N = paraboloid(-0.0122, 0.0011, 0.006, 2.0);
    const std::vector<float> other = paraboloid(0.0131, -0.0012, 0.006, 1.5);
    for (std::size_t i = 0; i < load_N.size(); ++i)
        load_N[i] += other[i];
    teleta::contact::ContactSegmenter segmenter(kArray, {.threshold_N = kThreshold_N});
    const auto contacts = segmenter.segment(load_N);
    ASSERT_EQ(contacts.size(), 2U);
    const auto first = summitOf(load_N, kArray, segmenter, contacts[0]);
    const auto second = summitOf(load_N, kArray, segmenter, contacts[1]);
    ASSERT_TRUE(first && second);
    EXPECT_NEAR(first->x_m, -0.0122, 1e-8);
    EXPECT_NEAR(first->y_m, 0.0011, 1e-8);
    EXPECT_NEAR(second->x_m, 0.0131, 1e-8);
    EXPECT_NEAR(second->y_m, -0.0012, 1e-8);
}

// A ball on a bed of springs, for which the paraboloid is right, with noise on the taxels that are pressed.
TEST(Summit, standardErrorsOfAnArrayHoldTheTruth) {
    teleta::core::RandomStream random(1, "summit test");
    constexpr int kCases = 1000;
    for (const double noise_N : {0.005, 0.03}) {
        int heldX = 0, heldY = 0, found = 0;
        for (int i = 0; i < kCases; ++i) {
            const double x_m = 0.02 * (random.uniform() - 0.5);
            const double y_m = 0.006 * (random.uniform() - 0.5);
            std::vector<float> load_N = paraboloid(x_m, y_m, 0.009, 2.0);
            for (float& load : load_N)
                if (load > 0.2F)
                    load += static_cast<float>(noise_N * random.normal());
                else
                    load = 0.0F;
            const auto summit = summitOf(load_N, kArray, kThreshold_N, {}, noise_N);
            ASSERT_TRUE(summit && summit->xSe_m && summit->ySe_m);
            ++found;
            heldX += std::abs(summit->x_m - x_m) <= 1.96 * *summit->xSe_m ? 1 : 0;
            heldY += std::abs(summit->y_m - y_m) <= 1.96 * *summit->ySe_m ? 1 : 0;
        }
        for (const int held : {heldX, heldY}) {
            EXPECT_GE(held, 0.93 * found) << noise_N;
            EXPECT_LE(held, 0.985 * found) << noise_N;
        }
    }
    EXPECT_FALSE(summitOf(paraboloid(0.0, 0.0, 0.009, 2.0), kArray, kThreshold_N)->xSe_m)
        << "without the noise there is none";
}
