// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

Intensities at(const char* id, double t_s) {
    const Pattern* pattern = findBuiltIn(id);
    if (pattern == nullptr) {
        ADD_FAILURE() << id;
        return {};
    }
    return evaluate(*pattern, t_s);
}

std::set<std::size_t> onTactors(const char* id, double t_s) {
    std::set<std::size_t> on;
    const Intensities intensities = at(id, t_s);
    for (std::size_t i = 0; i < intensities.size(); ++i) {
        if (intensities[i] > 0.0)
            on.insert(i);
    }
    return on;
}

} // namespace

TEST(BuiltInPatterns, areThe22StimuliOfThePaper) {
    std::set<std::string> expected;
    for (const std::string condition : {"static", "dynamic"}) {
        for (const char letter : std::string("ABCDEF"))
            expected.insert(std::string("shape.") + letter + '.' + condition);
        for (const char letter : std::string("ABCDE"))
            expected.insert(std::string("stiffness.") + letter + '.' + condition);
    }
    std::set<std::string> found;
    for (const Pattern& pattern : builtInPatterns())
        found.insert(pattern.id);
    EXPECT_EQ(builtInPatterns().size(), 22U);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(findBuiltIn("shape.G.static"), nullptr);
    EXPECT_EQ(findBuiltIn(""), nullptr);
}

TEST(BuiltInPatterns, shapesLastTwoSecondsAndEndWithSilence) {
    for (const Pattern& pattern : builtInPatterns()) {
        if (pattern.task == Task::shape || pattern.condition == Condition::constant) {
            EXPECT_EQ(pattern.duration_s, 2.0) << pattern.id;
        }
        EXPECT_EQ(evaluate(pattern, pattern.duration_s), Intensities{}) << pattern.id;
    }
}

TEST(BuiltInPatterns, staticShapesHaveAllTheirTactorsOnAllTheTime) {
    const std::vector<std::pair<const char*, std::size_t>> tactors{
        {"shape.A.static", 6}, {"shape.B.static", 4}, {"shape.C.static", 3},
        {"shape.D.static", 3}, {"shape.E.static", 2}, {"shape.F.static", 1}};
    for (const auto& [id, count] : tactors) {
        EXPECT_EQ(onTactors(id, 0.0).size(), count) << id;
        EXPECT_EQ(onTactors(id, 0.0), onTactors(id, 1.999)) << id;
    }
}

TEST(BuiltInPatterns, dynamicClosedShapesLightTheirTactorsOneByOneCounterClockwise) {
    for (const auto& [dynamicId, staticId] :
         {std::pair{"shape.A.dynamic", "shape.A.static"}, std::pair{"shape.B.dynamic", "shape.B.static"},
          std::pair{"shape.C.dynamic", "shape.C.static"}}) {
        std::vector<std::size_t> order;
        for (int k = 0; k < 2000; ++k) {
            const std::set<std::size_t> on = onTactors(dynamicId, 0.001 * k + 0.0005);
            ASSERT_EQ(on.size(), 1U) << dynamicId << ' ' << k;
            if (order.empty() || order.back() != *on.begin())
                order.push_back(*on.begin());
        }
        EXPECT_TRUE(std::is_sorted(order.begin(), order.end())) << dynamicId;
        EXPECT_EQ(std::set(order.begin(), order.end()), onTactors(staticId, 1.0));
        EXPECT_EQ(order.size(), onTactors(staticId, 1.0).size());
    }
}

TEST(BuiltInPatterns, dynamicArcIsStrongestInTheMiddle) {
    for (const double t_s : {0.3, 1.0, 1.7}) {
        const Intensities arc = at("shape.D.dynamic", t_s);
        EXPECT_GT(arc[0], arc[1]);
        EXPECT_EQ(arc[1], arc[5]);
        EXPECT_GT(arc[1], 0.0);
    }
}

TEST(BuiltInPatterns, dynamicLineHasOppositeRampsOnOppositeTactors) {
    for (const double t_s : {0.0, 0.5, 1.5}) {
        const Intensities line = at("shape.E.dynamic", t_s);
        EXPECT_DOUBLE_EQ(line[0], 1.0 - t_s / 2.0);
        EXPECT_DOUBLE_EQ(line[3], t_s / 2.0);
    }
}

TEST(BuiltInPatterns, levelsAreTheFrequenciesOfThePaper) {
    // A motor whose speed follows its voltage, from a third of it on: 250 Hz (1/3 + 2/3 i).
    const std::array<double, 5> paper_Hz{167, 188, 208, 229, 250};
    for (int level = 1; level <= 5; ++level) {
        const double speed_Hz = 250.0 * (1.0 + 2.0 * levelIntensity(level)) / 3.0;
        EXPECT_EQ(std::round(speed_Hz), paper_Hz[static_cast<std::size_t>(level - 1)]);
    }
    EXPECT_EQ(levelIntensity(0), levelIntensity(1));
    EXPECT_EQ(levelIntensity(6), levelIntensity(5));
}

TEST(BuiltInPatterns, dynamicStiffnessIsShorterAndStrongerTheStifferTheMaterial) {
    const std::array ids{"stiffness.A.dynamic", "stiffness.B.dynamic", "stiffness.C.dynamic",
                         "stiffness.D.dynamic", "stiffness.E.dynamic"};
    double duration_s = 3.0;
    double peak = 0.0;
    for (const char* id : ids) {
        const Pattern& pattern = *findBuiltIn(id);
        EXPECT_LT(pattern.duration_s, duration_s);
        duration_s = pattern.duration_s;
        double highest = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const Intensities all = evaluate(pattern, 0.001 * k * duration_s);
            highest = std::max(highest, all[0]);
            EXPECT_EQ(all, (Intensities{all[0], all[0], all[0], all[0], all[0], all[0]}));
        }
        EXPECT_GT(highest, peak);
        peak = highest;
    }
    EXPECT_EQ(duration_s, 0.3);
}

TEST(BuiltInPatterns, spongeIsOnePeriodOfASineOverTwoSeconds) {
    for (const double t_s : {0.0, 0.2, 0.5, 1.0, 1.6}) {
        const double sine = 0.5 * (1.0 + std::sin(std::numbers::pi * (t_s - 0.5)));
        EXPECT_NEAR(at("stiffness.A.dynamic", t_s)[3], levelIntensity(1) * sine, 1e-15);
    }
}
