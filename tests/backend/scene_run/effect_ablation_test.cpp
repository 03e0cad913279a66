// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/effect_ablation.h"
#include "backend/scene_run/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace teleta::scene_run {
namespace {

scene::Scene indenterWith(std::vector<scene::Effect> effects) {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/tactile-indenter.toml");
    EXPECT_TRUE(scene) << describe(scene.error());
    scene->effects = std::move(effects);
    return *scene;
}

double measured(const scene::Scene& scene, std::uint64_t seed, const char* measure) {
    RunOptions options;
    options.seed = seed;
    options.duration_s = 4.0;
    const auto summary = runScene(scene, options);
    EXPECT_TRUE(summary) << describe(summary.error());
    return summary->measures[measure].get<double>();
}

const MeasureChange& changeOf(const EffectAblation& effect, const std::string& measure) {
    const auto found = std::ranges::find(effect.changes, measure, &MeasureChange::measure);
    EXPECT_NE(found, effect.changes.end()) << measure;
    return *found;
}

AblationOptions fourSeconds(std::uint64_t seeds) {
    AblationOptions options;
    options.seeds = seeds;
    options.duration_s = 4.0;
    return options;
}

} // namespace

TEST(EffectAblation, tellsTheMeanDifferenceAndTheSpreadOfTheRunsOneByOne) {
    const scene::Scene noisy = indenterWith({{"", scene::NoiseSpec{.sd_N = 0.03}}});
    const scene::Scene clean = indenterWith({});
    const char* measure = "contact_error_mean_m";
    const double a = measured(noisy, 1, measure);
    const double b = measured(noisy, 2, measure);
    const double without = measured(clean, 1, measure);
    ASSERT_EQ(without, measured(clean, 2, measure)) << "without noise nothing is random in this scene";

    const auto ablation = ablateEffects(noisy, fourSeconds(2));
    ASSERT_TRUE(ablation) << describe(ablation.error());
    ASSERT_EQ(ablation->effects.size(), 1U);
    EXPECT_EQ(ablation->effects[0].effect, "noise");
    EXPECT_GT(ablation->effects[0].own_s, 0.0);
    const MeasureChange& change = changeOf(ablation->effects[0], measure);
    const double rounding = 1e-12 * a;
    EXPECT_NEAR(change.mean, 0.5 * (a + b), rounding);
    EXPECT_NEAR(change.spreadWith, std::abs(a - b) / std::sqrt(2.0), rounding);
    EXPECT_NEAR(change.meanWithout, without, rounding);
    EXPECT_NEAR(change.change, without - 0.5 * (a + b), rounding);
    EXPECT_EQ(change.spreadWithout, 0.0);
    // Two seeds: both differences have the same sign in half of all cases.
    EXPECT_EQ(change.pMean, 0.5);
    EXPECT_EQ(change.moves, Moves::yes) << "noise of 30 mN moves the contact by more than it scatters";
    EXPECT_TRUE(ablation->effects[0].moves());
    EXPECT_EQ(changeOf(ablation->effects[0], "frames").moves, Moves::no);
}

TEST(EffectAblation, anEffectThatDoesNothingMovesNothing) {
    // Steps far below every load of the scene; the noise gives the measures a spread.
    const scene::Scene scene =
        indenterWith({{"", scene::NoiseSpec{.sd_N = 0.015}}, {"", scene::QuantizationSpec{.step_N = 1e-12}}});
    const auto ablation = ablateEffects(scene, fourSeconds(3));
    ASSERT_TRUE(ablation) << describe(ablation.error());
    ASSERT_EQ(ablation->effects.size(), 2U);
    EXPECT_EQ(ablation->effects[1].effect, "quantization");
    EXPECT_FALSE(ablation->effects[1].moves());
}

// Noise of 0.1 mN is far below every load: it scatters errors about the same mean.
TEST(EffectAblation, anEffectThatActsOnTheSpreadOnlyIsSeen) {
    const scene::Scene noisy = indenterWith({{"", scene::NoiseSpec{.sd_N = 0.0001}}});
    const auto ablation = ablateEffects(noisy, fourSeconds(8));
    ASSERT_TRUE(ablation) << describe(ablation.error());
    bool seen = false;
    for (const MeasureChange& change : ablation->effects[0].changes) {
        if (change.moves != Moves::spread)
            continue;
        seen = true;
        EXPECT_LE(std::abs(change.change), change.spreadWith) << change.measure;
        EXPECT_GT(change.spreadWith, 0.0);
        EXPECT_LE(change.spreadWithout, 1e-12 * std::abs(change.mean))
            << "without noise nothing is random in this scene";
        EXPECT_LT(change.pSpread, 0.05);
    }
    EXPECT_TRUE(seen);
    EXPECT_TRUE(ablation->effects[0].moves());
}

TEST(EffectAblation, aSceneWithoutEffectsHasNothingToLeaveOut) {
    const auto ablation = ablateEffects(indenterWith({}), fourSeconds(2));
    ASSERT_TRUE(ablation) << describe(ablation.error());
    EXPECT_TRUE(ablation->effects.empty());
}

TEST(EffectAblation, oneSeedHasNoSpreadAndIsRefused) {
    const auto ablation = ablateEffects(indenterWith({}), fourSeconds(1));
    ASSERT_FALSE(ablation);
    EXPECT_EQ(ablation.error().kind, core::ErrorKind::badInput);
}

TEST(EffectAblation, endsWhenItIsToldTo) {
    AblationOptions options = fourSeconds(2);
    double last = 0.0;
    options.goOn = [&last](double runs, double allRuns) {
        EXPECT_GE(runs, last);
        EXPECT_LE(runs, allRuns);
        last = runs;
        return runs < 1.0;
    };
    const auto ablation = ablateEffects(indenterWith({{"", scene::NoiseSpec{.sd_N = 0.015}}}), options);
    ASSERT_FALSE(ablation);
    EXPECT_EQ(ablation.error().kind, core::ErrorKind::cancelled);
}

} // namespace teleta::scene_run
