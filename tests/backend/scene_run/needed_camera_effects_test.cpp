// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/scene_run/shipped_scenes.h"

namespace teleta::scene_run {

using test_scenes::ShippedScene;

class NeededCameraEffects : public testing::TestWithParam<ShippedScene> {};

/// Pictures of two million pixels take minutes. Fewer than five seeds do not tell the spread.
TEST_P(NeededCameraEffects, everyEffectMovesAMeasureByMoreThanTheMeasuresOwnSpread) {
    AblationOptions options;
    options.seeds = 5;
    const auto& scene = std::get<scene::Scene>(GetParam().scene);
    options.duration_s = std::min(scene.duration_s, 100.0);
    test_scenes::expectThatAllEffectsMoveAMeasure(GetParam(), options);
}

INSTANTIATE_TEST_SUITE_P(Scenes, NeededCameraEffects, testing::ValuesIn(test_scenes::shippedScenes(true)),
                         test_scenes::testNameOf);

} // namespace teleta::scene_run
