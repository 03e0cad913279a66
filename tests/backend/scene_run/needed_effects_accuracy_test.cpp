// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/scene_run/shipped_scenes.h"

namespace teleta::scene_run {

using test_scenes::ShippedScene;

class NeededEffects : public testing::TestWithParam<ShippedScene> {};

TEST_P(NeededEffects, everyEffectMovesAMeasureByMoreThanTheMeasuresOwnSpread) {
    AblationOptions options;
    options.seeds = 4;
    if (GetParam().name == "teleoperation")
        options.duration_s = 75.0; // the first of three objects
    test_scenes::expectThatAllEffectsMoveAMeasure(GetParam(), options);
}

INSTANTIATE_TEST_SUITE_P(Scenes, NeededEffects, testing::ValuesIn(test_scenes::shippedScenes(false)),
                         test_scenes::testNameOf);

} // namespace teleta::scene_run
