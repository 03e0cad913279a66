// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace teleta::stiffness;

TEST(Material, paperObjectsFallIntoTheirOwnClass) {
    EXPECT_EQ(classify(282.0), Material::sponge);
    EXPECT_EQ(classify(1325.9), Material::rubberSponge);
    EXPECT_EQ(classify(7223.9), Material::rubber);
    EXPECT_EQ(classify(8562.9), Material::wood);
    EXPECT_EQ(classify(std::numeric_limits<double>::infinity()), Material::metal);
}

TEST(Material, bordersAreTheGeometricMeansOfTheNeighbours) {
    const auto& bands = materialBands();
    for (std::size_t i = 0; i + 1 < bands.size(); ++i) {
        const double border_NPerM = std::sqrt(bands[i].typical_NPerM * bands[i + 1].typical_NPerM);
        EXPECT_NEAR(bands[i].upper_NPerM.value(), border_NPerM, 1e-3);
    }
    EXPECT_DOUBLE_EQ(kMetalStiffness_NPerM, 10.0 * 3468.6);
}

TEST(Material, bandsCoverTheScaleWithoutGaps) {
    const auto& bands = materialBands();
    EXPECT_EQ(bands.front().lower_NPerM, 0.0);
    EXPECT_FALSE(bands.back().upper_NPerM);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        EXPECT_EQ(level(bands[i].material), static_cast<int>(i) + 1);
        EXPECT_EQ(classify(bands[i].lower_NPerM), bands[i].material) << "a band holds its lower border";
        if (i + 1 < bands.size()) {
            EXPECT_EQ(bands[i].upper_NPerM.value(), bands[i + 1].lower_NPerM);
            EXPECT_EQ(classify(std::nextafter(*bands[i].upper_NPerM, 0.0)), bands[i].material);
        }
    }
}

TEST(Material, onlyTheSpongesAreSafe) {
    EXPECT_TRUE(isSafe(Material::sponge));
    EXPECT_TRUE(isSafe(Material::rubberSponge));
    EXPECT_FALSE(isSafe(Material::rubber));
    EXPECT_FALSE(isSafe(Material::wood));
    EXPECT_FALSE(isSafe(Material::metal));
}

TEST(Material, anUnknownStiffnessIsTakenAsHard) {
    EXPECT_EQ(classify(std::numeric_limits<double>::quiet_NaN()), Material::metal);
}

TEST(Material, namesAreThoseOfTheFiles) {
    const char* names[] = {"sponge", "rubber_sponge", "rubber", "wood", "metal"};
    for (std::size_t i = 0; i < materialBands().size(); ++i) {
        const Material material = materialBands()[i].material;
        EXPECT_EQ(std::string(toString(material)), names[i]);
    }
}
