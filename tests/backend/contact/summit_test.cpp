// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/summit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace teleta::contact;
using teleta::core::ArrayLayout;

namespace {

const ArrayLayout kArray{.rows = 6, .columns = 14, .pitch_m = 0.0034};

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

constexpr float kThreshold_N = 0.05F;

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
        const auto summit =
            summitOf(paraboloid(0.002, -0.001, 0.009, 2.0 * scale), kArray, static_cast<float>(0.05 * scale));
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
