// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/model/pattern_map.h"

#include <gtest/gtest.h>

using namespace teleta::pattern;

TEST(PatternMap, defaultsAreBuiltInPatternsOfTheSameLevelAndShape) {
    const PatternMap map = PatternMap::defaults();
    EXPECT_EQ(map.ofStiffness(1), "stiffness.A.dynamic");
    EXPECT_EQ(map.ofStiffness(5), "stiffness.E.dynamic");
    EXPECT_EQ(map.ofShape("circle"), "shape.A.dynamic");
    EXPECT_EQ(map.ofShape("point"), "shape.F.dynamic");
    for (const std::string& id : map.stiffness)
        EXPECT_NE(findBuiltIn(id), nullptr) << id;
    for (std::size_t i = 0; i + 1 < map.shape.size(); ++i)
        EXPECT_NE(findBuiltIn(map.shape[i]), nullptr) << map.shape[i];
}

TEST(PatternMap, hasNothingForWhatIsUnknown) {
    const PatternMap map = PatternMap::defaults();
    EXPECT_EQ(map.ofShape("unknown"), "");
    EXPECT_EQ(map.ofShape("hexagon"), "");
    EXPECT_EQ(map.ofStiffness(0), "");
    EXPECT_EQ(map.ofStiffness(6), "");
}
