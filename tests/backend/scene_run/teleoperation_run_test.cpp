// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace teleta::scene_run {

namespace {

/// A pattern that rises from 0 is felt with its second frame.
constexpr double kTwoFrames_s = 0.01;
/// Until the first material or shape is certain.
constexpr double kLongEnough_s = 120.0;

scene::Scene teleoperation() {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/teleoperation.toml");
    EXPECT_TRUE(scene) << describe(scene.error());
    return *scene;
}

scene::LinkDelaySpec& linkOf(scene::Scene& scene) {
    const auto found = std::ranges::find_if(scene.effects, [](const scene::Effect& effect) {
        return std::holds_alternative<scene::LinkDelaySpec>(effect.parameters);
    });
    return std::get<scene::LinkDelaySpec>(found->parameters);
}

SceneSummary run(const scene::Scene& scene, double duration_s, const std::string& folder = {}) {
    RunOptions options;
    options.duration_s = duration_s;
    options.outFolder = folder;
    auto summary = runScene(scene, options);
    EXPECT_TRUE(summary) << describe(summary.error());
    return std::move(*summary);
}

bool hasEvent(const SceneSummary& summary, const std::string& name) {
    return std::ranges::any_of(summary.events, [&](const auto& event) { return event["event"] == name; });
}

} // namespace

TEST(TeleoperationRun, isFeltLaterByTheDelayOfTheLinkAndNoEarlier) {
    scene::Scene scene = teleoperation();
    // A link without chance: the way back, then up to the next frame of the bracelet.
    linkOf(scene) = {.delay_s = 0.1};
    const SceneSummary late = run(scene, kLongEnough_s);
    const double p50_s = late.measures["touch_to_tactor_p50_s"].get<double>();
    const double p99_s = late.measures["touch_to_tactor_p99_s"].get<double>();
    EXPECT_GE(p50_s, 0.1);
    EXPECT_LE(p99_s, 0.1 + kTwoFrames_s + 0.001);
    EXPECT_GE(late.measures["patterns_sent"].get<int>(), 2);
    EXPECT_EQ(late.measures["frames_lost"], 0);
    linkOf(scene) = {};
    EXPECT_LE(run(scene, kLongEnough_s).measures["touch_to_tactor_p99_s"].get<double>(),
              kTwoFrames_s + 0.001);
}

TEST(TeleoperationRun, sameSeedSameBytes) {
    const test::TemporaryFolder a;
    const test::TemporaryFolder b;
    run(teleoperation(), 20.0, a.path("run"));
    run(teleoperation(), 20.0, b.path("run"));
    for (const char* file : {"joints.csv", "frames.csv", "touches.csv", "objects.csv", "bracelet.csv"}) {
        const std::string content = test::readAll(a.path("run/") + file);
        EXPECT_EQ(content, test::readAll(b.path("run/") + file)) << file;
        EXPECT_GT(std::ranges::count(content, '\n'), 1) << file;
    }
}

TEST(TeleoperationRun, tellsOfALinkThatIsLostAndComesBack) {
    scene::Scene scene = teleoperation();
    linkOf(scene) = {.delay_s = 0.02, .outageAt_s = 5.0, .outage_s = 1.0};
    const SceneSummary summary = run(scene, 8.0);
    ASSERT_TRUE(hasEvent(summary, "link_lost"));
    ASSERT_TRUE(hasEvent(summary, "link_back"));
    for (const auto& event : summary.events) {
        if (event["event"] == "link_lost") {
            EXPECT_NEAR(event["time_s"].get<double>(), 5.0 + 0.02 + 0.1, 0.003);
        }
        if (event["event"] == "link_back") {
            EXPECT_NEAR(event["time_s"].get<double>(), 6.0 + 0.02, 0.003);
        }
    }
    // 200 frames a second for a second.
    EXPECT_NEAR(summary.measures["frames_lost"].get<int>(), 200, 1);
    EXPECT_FALSE(hasEvent(run(teleoperation(), 8.0), "link_lost"));
}

} // namespace teleta::scene_run
