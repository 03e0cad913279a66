// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_plan.h"

#include <gtest/gtest.h>

using namespace teleta;

namespace {

core::Error errorOf(const std::string& text) {
    const auto plan = sweep::parseSweepPlan(text, "a.toml");
    EXPECT_FALSE(plan);
    return plan ? core::Error{} : plan.error();
}

} // namespace

TEST(SweepPlan, isTheProductOfItsAxesWithPairsThatGoTogether) {
    const auto plan = sweep::parseSweepPlan(R"([sweep]
scene = "teleta-touch"
seeds = "11:13"
measures = ["a", "b"]
[sweep.vary]
"object.0.stiffness_N_per_m" = [200.0, 1000]
effect.torque_noise.sd_Nm = { from = 0.0001, to = 0.01, steps = 3, scale = "log10" }
[sweep.pairs]
"arm.speed" = [1, 2]
"arm.kind" = ["slow", "quick"]
)",
                                            "a.toml");
    ASSERT_TRUE(plan) << describe(plan.error());
    EXPECT_EQ(plan->cells(), 12U);
    EXPECT_EQ(plan->runs(), 36U);
    EXPECT_EQ(plan->seedOf(0), 11U);
    EXPECT_EQ(plan->seedOf(5), 13U);
    EXPECT_EQ(plan->cellOf(5), 1U);
    EXPECT_EQ(plan->keys(), (std::vector<std::string>{"object.0.stiffness_N_per_m",
                                                      "effect.torque_noise.sd_Nm", "arm.speed", "arm.kind"}));
    // The last axis runs fastest, and its keys together.
    const auto settings = plan->settingsOf(3);
    EXPECT_EQ(core::plainText(settings[0].second), "200");
    EXPECT_DOUBLE_EQ(std::get<double>(settings[1].second), 0.001);
    EXPECT_EQ(core::plainText(settings[2].second), "2");
    EXPECT_EQ(core::plainText(settings[3].second), "quick");
    // The ends of a range are what the file says.
    EXPECT_EQ(std::get<double>(plan->settingsOf(0)[1].second), 0.0001);
    EXPECT_EQ(std::get<double>(plan->settingsOf(11)[1].second), 0.01);
    EXPECT_TRUE(plan->axes[1].logarithmic);
    EXPECT_TRUE(plan->axes[0].isNumeric());
    EXPECT_FALSE(plan->axes[2].isNumeric());
}

TEST(SweepPlan, withoutAnythingVariedHasOneCell) {
    const auto plan = sweep::parseSweepPlan("[sweep]\nladder = \"contour\"\nseeds = \"7\"\n", "a.toml");
    ASSERT_TRUE(plan) << describe(plan.error());
    EXPECT_EQ(plan->cells(), 1U);
    EXPECT_EQ(plan->runs(), 1U);
    EXPECT_EQ(plan->seedOf(0), 7U);
    EXPECT_TRUE(plan->settingsOf(0).empty());
}

TEST(SweepPlan, saysLineAndColumnOfWhatIsWrong) {
    const core::Error two = errorOf("[sweep]\nscene = \"a\"\nladder = \"b\"\n");
    EXPECT_NE(two.expected.find("scene, study, ladder"), std::string::npos);
    const core::Error seeds = errorOf("[sweep]\nscene = \"a\"\nseeds = \"9:3\"\n");
    EXPECT_EQ(seeds.where.line, 3);
    EXPECT_EQ(seeds.where.column, 9);
    const core::Error unlike = errorOf("[sweep]\nscene = \"a\"\n[sweep.pairs]\nx = [1, 2]\ny = [1, 2, 3]\n");
    EXPECT_EQ(unlike.where.line, 5);
    const core::Error zero = errorOf(
        "[sweep]\nscene = \"a\"\n[sweep.vary]\nx = { from = 0.0, to = 1.0, steps = 3, scale = \"log10\" }\n");
    EXPECT_EQ(zero.where.line, 4);
    EXPECT_EQ(errorOf("[sweep]\nscene = \"a\"\n[sweep.vary]\nx = []\n").where.line, 4);
    EXPECT_EQ(errorOf("[sweep]\nscene = \"a\"\n[sweep.vary]\nx = [[1]]\n").where.line, 4);
    EXPECT_EQ(errorOf("[sweep]\nscene = \"a\"\n[sweep.vary]\nx = [1]\n[sweep.pairs]\nx = [2]\n").where.line,
              6);
    EXPECT_EQ(errorOf("[sweep]\nscene = \"a\"\nsceen = 1\n").where.line, 3);
    EXPECT_EQ(
        errorOf("[sweep]\nscene = \"a\"\nseeds = \"1:100000\"\n[sweep.vary]\nx = {from=0,to=1,steps=9999}\n")
            .kind,
        core::ErrorKind::badInput);
}
