// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_names.h"

#include <gtest/gtest.h>

using teleta::core::KeyMatch;
using teleta::core::matchKey;
using teleta::core::nearestName;

TEST(KeyNames, tellsAMissingUnitFromAnotherUnitAndFromAMisspelling) {
    const std::vector<std::string> allowed{"radius_m", "stiffness_N_per_m", "name", "rate_Hz"};
    const auto kind = [&](const char* key) { return matchKey(key, allowed).kind; };
    EXPECT_EQ(kind("radius"), KeyMatch::Kind::unitMissing);
    EXPECT_EQ(kind("radius_mm"), KeyMatch::Kind::otherUnit);
    EXPECT_EQ(kind("stiffness_N_per_mm"), KeyMatch::Kind::otherUnit);
    EXPECT_EQ(kind("rate_kHz"), KeyMatch::Kind::otherUnit);
    EXPECT_EQ(kind("radus_m"), KeyMatch::Kind::similar);
    EXPECT_EQ(kind("nam"), KeyMatch::Kind::similar);
    EXPECT_EQ(kind("temperature"), KeyMatch::Kind::none);
    EXPECT_EQ(matchKey("stiffness", allowed).name, "stiffness_N_per_m");
    EXPECT_EQ(matchKey("radus_m", allowed).name, "radius_m");
}

TEST(KeyNames, findsTheNearestNameAndOnlyANearOne) {
    EXPECT_EQ(nearestName("nosie", {"drift", "noise"}), "noise");
    EXPECT_EQ(nearestName("Noise", {"drift", "noise"}), "noise");
    EXPECT_EQ(nearestName("latency", {"drift", "noise"}), "");
    EXPECT_EQ(nearestName("", {"drift", "noise"}), "");
    EXPECT_EQ(nearestName("noise", {}), "");
}
