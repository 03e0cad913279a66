// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

TEST(ShippedScenes, canAllBeRead) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(TELETA_SOURCE_DIR "/resources/scenes")) {
        // Scenes of studies are read elsewhere.
        if (entry.path().extension() != ".toml" || entry.path().stem() == "study-rehearsal")
            continue;
        const auto scene = teleta::scene::readScene(entry.path().string());
        EXPECT_TRUE(scene) << describe(scene.error());
        ++scenes;
    }
    EXPECT_GE(scenes, 3);
}
