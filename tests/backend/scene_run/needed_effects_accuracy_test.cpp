// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/effect_ablation.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace teleta::scene_run {

namespace {

template <typename AnyScene>
void expectThatAllEffectsMoveAMeasure(const AnyScene& scene, const std::string& name) {
    AblationOptions options;
    options.seeds = 6;
    const auto ablation = ablateEffects(scene, options);
    ASSERT_TRUE(ablation) << describe(ablation.error());
    ASSERT_EQ(ablation->effects.size(), scene.effects.size());
    for (std::size_t i = 0; i < scene.effects.size(); ++i) {
        const EffectAblation& effect = ablation->effects[i];
        EXPECT_TRUE(effect.moves()) << effect.effect << " does not belong in this scene";
        EXPECT_FALSE(scene.effects[i].why.empty()) << effect.effect;
        for (const MeasureChange& change : effect.changes)
            if (change.moves)
                std::cout << name << " without " << effect.effect << ": " << change.measure << " "
                          << change.mean << " -> " << change.meanWithout << ", spread " << change.spread
                          << '\n';
    }
}

std::string fileOf(const std::string& name) {
    return TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml";
}

} // namespace

class NeededEffects : public testing::TestWithParam<const char*> {};

TEST_P(NeededEffects, everyEffectMovesAMeasureByMoreThanTheMeasuresOwnSpread) {
    const auto scene = scene::readScene(fileOf(GetParam()));
    ASSERT_TRUE(scene) << describe(scene.error());
    expectThatAllEffectsMoveAMeasure(*scene, GetParam());
}

TEST(NeededEffectsOfStudies, everyEffectMovesAMeasureByMoreThanTheMeasuresOwnSpread) {
    const std::string file = fileOf("study-rehearsal");
    const auto scene = study::parseStudyScene(test::readAll(file), file);
    ASSERT_TRUE(scene) << describe(scene.error());
    expectThatAllEffectsMoveAMeasure(*scene, "study-rehearsal");
}

INSTANTIATE_TEST_SUITE_P(Scenes, NeededEffects,
                         testing::Values("servo-straight-bar", "servo-bent-bar", "servo-bent-bar-baseline",
                                         "servo-comanipulation", "servo-roll", "servo-point", "teleta-touch",
                                         "teleta-admittance", "teleta-contour-circle",
                                         "teleta-contour-rectangle", "teleta-contour-triangle"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace teleta::scene_run
