// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using teleta::core::RandomStream;

TEST(RandomStream, followsFromSeedAndNameAlone) {
    RandomStream noise(1, "noise");
    RandomStream same(1, "noise");
    RandomStream otherSeed(2, "noise");
    RandomStream otherName(1, "drift");
    for (int i = 0; i < 100; ++i) {
        const double value = noise.normal();
        EXPECT_EQ(value, same.normal());
        EXPECT_NE(value, otherSeed.normal());
        EXPECT_NE(value, otherName.normal());
    }
    const double next = noise.normal();
    EXPECT_EQ(next, same.normal());
}

TEST(RandomStream, beginsAnewAfterRestart) {
    RandomStream stream(7, "x");
    const double first = stream.normal();
    stream.restart();
    EXPECT_EQ(stream.normal(), first);
}

TEST(RandomStream, hasTheMomentsOfItsDistributions) {
    RandomStream stream(3, "moments");
    constexpr int kCount = 1'000'000;
    double mean = 0.0, square = 0.0, fourth = 0.0, uniform = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double value = stream.normal();
        mean += value / kCount;
        square += value * value / kCount;
        fourth += value * value * value * value / kCount;
        uniform += stream.uniform() / kCount;
    }
    // Five standard errors: of the mean 1/sqrt(n), of the square sqrt(2/n), of the fourth moment sqrt(96/n).
    const double root = std::sqrt(static_cast<double>(kCount));
    EXPECT_NEAR(mean, 0.0, 5.0 / root);
    EXPECT_NEAR(square, 1.0, 5.0 * std::sqrt(2.0) / root);
    EXPECT_NEAR(fourth, 3.0, 5.0 * std::sqrt(96.0) / root);
    EXPECT_NEAR(uniform, 0.5, 5.0 / std::sqrt(12.0) / root);
}

TEST(RandomStream, drawsEveryIndexEquallyOften) {
    RandomStream stream(3, "below");
    std::array<int, 7> counts{};
    constexpr int kCount = 70'000;
    for (int i = 0; i < kCount; ++i)
        ++counts.at(stream.below(counts.size()));
    for (const int count : counts)
        EXPECT_NEAR(count, kCount / 7.0, 5.0 * std::sqrt(kCount / 7.0));
}

// The standard fixes the 10000th output of mt19937_64 with its default seed.
TEST(RandomStream, isTheGeneratorOfTheStandard) {
    RandomStream random(std::mt19937_64::default_seed);
    for (int i = 1; i < 10000; ++i)
        (void)random.below(1);
    EXPECT_EQ(random.below(std::uint64_t{1} << 63U), 9981545732273789042U % (std::uint64_t{1} << 63U));
}
