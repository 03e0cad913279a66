// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/temperature_drift.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace teleta::core {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(TemperatureDrift, tellsTheChipThatMovedMostInEitherDirection) {
    TemperatureDrift drift;
    EXPECT_FALSE(drift.largest());
    drift.take(std::vector{25.0F, 30.0F, 20.0F});
    EXPECT_FALSE(drift.largest()) << "these are the temperatures of the tare";
    drift.take(std::vector{26.0F, 27.0F, 22.0F});
    ASSERT_TRUE(drift.largest());
    EXPECT_EQ(drift.largest()->chip, 1U);
    EXPECT_DOUBLE_EQ(drift.largest()->change_K, -3.0);
    EXPECT_FALSE(drift.isTold());
}

TEST(TemperatureDrift, isToldBeyondFiveKelvinUntilItIsBelowFour) {
    TemperatureDrift drift;
    drift.take(std::vector{20.0F});
    for (const auto& [degC, told] : {std::pair{25.0F, false},
                                     {25.5F, true},
                                     {24.5F, true},
                                     {24.0F, false},
                                     {25.0F, false},
                                     {14.5F, true}}) {
        drift.take(std::vector{degC});
        EXPECT_EQ(drift.isTold(), told) << degC;
    }
}

TEST(TemperatureDrift, beginsAnewWithTheNextTemperatures) {
    TemperatureDrift drift;
    drift.take(std::vector{20.0F});
    drift.take(std::vector{40.0F});
    ASSERT_TRUE(drift.isTold());
    drift.restart();
    EXPECT_FALSE(drift.isTold());
    EXPECT_FALSE(drift.largest());
    drift.take(std::vector{40.0F});
    drift.take(std::vector{41.0F});
    EXPECT_FALSE(drift.isTold());
    EXPECT_DOUBLE_EQ(drift.largest()->change_K, 1.0);
}

TEST(TemperatureDrift, aChipWithoutATemperatureSaysNothing) {
    TemperatureDrift drift;
    drift.take(std::vector{20.0F, kNaN});
    drift.take(std::vector{kNaN, 30.0F});
    EXPECT_FALSE(drift.largest());
    drift.take(std::vector{21.0F, 38.0F});
    ASSERT_TRUE(drift.largest());
    EXPECT_EQ(drift.largest()->chip, 1U) << "since its own first temperature";
    EXPECT_DOUBLE_EQ(drift.largest()->change_K, 8.0);
    drift.take({});
    EXPECT_FALSE(drift.largest()) << "another number of chips begins anew";
}

TEST(TemperatureDrift, saysOnlyOfChipsWhoseTemperatureAtTheTareIsGiven) {
    TemperatureDrift drift;
    drift.restart(std::vector{20.0F, kNaN});
    drift.take(std::vector{21.0F, 20.0F});
    ASSERT_TRUE(drift.largest()) << "these are not those of the tare";
    EXPECT_EQ(drift.largest()->chip, 0U);
    EXPECT_DOUBLE_EQ(drift.largest()->change_K, 1.0);
    drift.take(std::vector{21.0F, 40.0F});
    EXPECT_EQ(drift.largest()->chip, 0U);
    EXPECT_FALSE(drift.isTold());

    for (const std::vector<float>& other : {std::vector<float>{}, {20.0F}, {20.0F, 20.0F, 20.0F}}) {
        drift.restart(other);
        drift.take(std::vector{20.0F, 20.0F});
        drift.take(std::vector{40.0F, 40.0F});
        EXPECT_FALSE(drift.largest()) << other.size() << " at the tare";
        EXPECT_FALSE(drift.isTold()) << other.size() << " at the tare";
        EXPECT_EQ(drift.atTare(), other);
    }
    drift.restart();
    drift.take(std::vector{20.0F, 20.0F});
    drift.take(std::vector{40.0F, 41.0F});
    EXPECT_TRUE(drift.isTold()) << "of a new tare";
}

} // namespace
} // namespace teleta::core
