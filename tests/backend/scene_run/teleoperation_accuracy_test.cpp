// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "backend/stiffness/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

namespace teleta::scene_run {

TEST(TeleoperationAccuracy, findsWhatAndWhereTheUnknownObjectsAre) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/teleoperation.toml");
    ASSERT_TRUE(scene) << describe(scene.error());
    constexpr std::uint64_t kSeeds = 6;
    int objects = 0;
    int materials = 0;
    int shapes = 0;
    int stiffnesses = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        RunOptions options;
        options.seed = seed;
        const auto summary = runScene(*scene, options);
        ASSERT_TRUE(summary) << describe(summary.error());
        const auto& measures = summary->measures;
        std::cout << "seed " << seed << ": " << measures.dump() << '\n';
        for (std::size_t i = 0; i < scene->arm().objects.size(); ++i) {
            const double truth = measures["true_stiffness_n_per_m"][i].get<double>();
            const auto& estimated = measures["estimated_stiffness_n_per_m"][i];
            ++objects;
            materials += measures["material"][i] == stiffness::toString(stiffness::classify(truth)) ? 1 : 0;
            const auto& shape = measures["shape"][i];
            // Ten touches may leave a corner open, but no wrong name is said.
            EXPECT_TRUE(shape == measures["true_shape"][i] || shape == "unknown") << seed << ": " << shape;
            shapes += shape == measures["true_shape"][i] ? 1 : 0;
            stiffnesses +=
                estimated.is_number() && std::abs(estimated.get<double>() / truth - 1.0) < 0.2 ? 1 : 0;
        }
        // The taxels are 9.4 mm wide.
        EXPECT_LT(measures["contact_error_mean_m"].get<double>(), 0.002) << seed;
        EXPECT_LT(measures["contact_error_p95_m"].get<double>(), 0.004) << seed;
        EXPECT_GE(measures["patterns_sent"].get<int>(), 6) << seed; // a material and a shape of each
    }
    std::cout << objects << " objects: " << materials << " materials, " << shapes << " shapes, "
              << stiffnesses << " stiffnesses within 20 %\n";
    EXPECT_GE(materials, 0.9 * objects);
    EXPECT_GE(shapes, 0.8 * objects);
    EXPECT_GE(stiffnesses, 0.9 * objects);
}

} // namespace teleta::scene_run
