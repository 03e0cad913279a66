// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/effect_ablation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace teleta::scene_run {

class NeededEffects : public testing::TestWithParam<const char*> {};

TEST_P(NeededEffects, everyEffectMovesAMeasureByMoreThanTheMeasuresOwnSpread) {
    const std::string name = GetParam();
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    AblationOptions options;
    options.seeds = 6;
    const auto ablation = ablateEffects(*scene, options);
    ASSERT_TRUE(ablation) << describe(ablation.error());
    for (std::size_t i = 0; i < scene->effects.size(); ++i) {
        const EffectAblation& effect = ablation->effects[i];
        EXPECT_TRUE(effect.moves()) << effect.effect << " does not belong in this scene";
        EXPECT_FALSE(scene->effects[i].why.empty()) << effect.effect;
        for (const MeasureChange& change : effect.changes)
            if (change.moves)
                std::cout << name << " without " << effect.effect << ": " << change.measure << " "
                          << change.mean << " -> " << change.meanWithout << ", spread " << change.spread
                          << '\n';
    }
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
