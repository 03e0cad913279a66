// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene_reader.h"
#include "backend/scene_run/effect_ablation.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

namespace teleta::scene_run::test_scenes {

using AnyScene = std::variant<scene::Scene, study::StudyScene>;

struct ShippedScene {
    std::string name; ///< of the file, without its suffix
    AnyScene scene;

    [[nodiscard]] bool isCamera() const {
        const auto* world = std::get_if<scene::Scene>(&scene);
        return world != nullptr && world->isCamera();
    }
};

/// All scenes that come with the programs, whatever they are called, in alphabetical order.
inline std::vector<ShippedScene> shippedScenes() {
    std::vector<ShippedScene> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(TELETA_SOURCE_DIR "/resources/scenes")) {
        const std::string file = entry.path().string();
        const std::string text = test::readAll(file);
        const auto add = [&](const auto& scene) {
            if (!scene)
                throw std::runtime_error(core::describe(scene.error()));
            scenes.push_back({entry.path().stem().string(), *scene});
        };
        if (study::isStudyScene(text))
            add(study::parseStudyScene(text, file));
        else
            add(scene::parseScene(text, file));
    }
    std::ranges::sort(scenes, {}, &ShippedScene::name);
    return scenes;
}

/// Those with a camera or those without, for INSTANTIATE_TEST_SUITE_P.
inline std::vector<ShippedScene> shippedScenes(bool withCamera) {
    std::vector<ShippedScene> scenes = shippedScenes();
    std::erase_if(scenes, [=](const ShippedScene& one) { return one.isCamera() != withCamera; });
    return scenes;
}

inline std::string testNameOf(const testing::TestParamInfo<ShippedScene>& test) {
    std::string name = test.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

/// Expects of each effect that it moves a measure by more than the measure's own spread, and prints which.
inline void expectThatAllEffectsMoveAMeasure(const ShippedScene& shipped, const AblationOptions& options) {
    std::visit(
        [&](const auto& scene) {
            const auto ablation = ablateEffects(scene, options);
            ASSERT_TRUE(ablation) << describe(ablation.error());
            ASSERT_EQ(ablation->effects.size(), scene.effects.size());
            for (std::size_t i = 0; i < scene.effects.size(); ++i) {
                const EffectAblation& effect = ablation->effects[i];
                EXPECT_TRUE(effect.moves()) << effect.effect << " does not belong in this scene";
                EXPECT_FALSE(scene.effects[i].why.empty()) << effect.effect;
                for (const MeasureChange& change : effect.changes)
                    if (change.moves != Moves::no)
                        std::cout << shipped.name << " without " << effect.effect << ": " << change.measure
                                  << ' ' << change.mean << " -> " << change.meanWithout << ", spread "
                                  << change.spreadWith << ", seeds that differ " << change.differing << '\n';
            }
        },
        shipped.scene);
}

inline void PrintTo(const ShippedScene& shipped, std::ostream* stream) {
    *stream << shipped.name;
}

} // namespace teleta::scene_run::test_scenes
