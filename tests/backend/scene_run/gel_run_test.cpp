// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>

namespace teleta::scene_run {
namespace {

nlohmann::ordered_json measuresOf(const std::string& name) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
    EXPECT_TRUE(scene) << (scene ? "" : describe(scene.error()));
    if (!scene)
        return {};
    RunOptions options;
    options.name = name;
    const auto summary = runScene(*scene, options);
    EXPECT_TRUE(summary) << (summary ? "" : describe(summary.error()));
    if (!summary)
        return {};
    std::cout << name << ": " << summary->measures.dump() << '\n';
    // Of each marker: uneven light, noise of 2 grey levels, print errors.
    EXPECT_LT(summary->measures["marker_error_px"].get<double>(), 0.1);
    return summary->measures;
}

} // namespace

TEST(GelRun, findsBallsThatPress) {
    const auto run = measuresOf("gel-press");
    // At first a touch moves no marker by more than noise does.
    EXPECT_LE(run["contacts_missed"].get<int>(), 3);
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), 0.0003);
    EXPECT_LT(run["contact_error_p95_m"].get<double>(), 0.0006);
    EXPECT_TRUE(run["incipient_slip_s"].is_null());
    EXPECT_TRUE(run["slip_s"].is_null());
}

TEST(GelRun, tellsTheDirectionOfShearAndNoSlipWhileTheBallSticks) {
    const auto run = measuresOf("gel-shear");
    EXPECT_EQ(run["contacts_missed"], 0);
    EXPECT_LT(run["shear_direction_error_rad"].get<double>(), 0.052); // 3 degrees
    EXPECT_TRUE(run["incipient_slip_s"].is_null());
    EXPECT_TRUE(run["true_incipient_slip_s"].is_null());
    EXPECT_TRUE(run["slip_s"].is_null());
}

TEST(GelRun, tellsIncipientSlipThenSlip) {
    const auto run = measuresOf("gel-slip");
    ASSERT_TRUE(run["incipient_slip_s"].is_number());
    ASSERT_TRUE(run["slip_s"].is_number());
    EXPECT_LT(run["incipient_slip_s"].get<double>(), run["slip_s"].get<double>());
    EXPECT_LT(run["slip_index_error"].get<double>(), 0.1);
    // Two frames.
    EXPECT_NEAR(run["incipient_slip_s"].get<double>(), run["true_incipient_slip_s"].get<double>(), 0.081);
    EXPECT_NEAR(run["slip_s"].get<double>(), run["true_slip_s"].get<double>(), 0.081);
}

TEST(GelRun, tellsTheTurnOfABallThatTwists) {
    const auto run = measuresOf("gel-twist");
    EXPECT_NEAR(run["true_turn_rad"].get<double>(), 0.15, 1e-9);
    EXPECT_GT(run["torsion_rad"].get<double>(), 0.0);
    EXPECT_LT(run["torsion_rad"].get<double>(), 0.15);
    EXPECT_LT(run["slip_index_error"].get<double>(), 0.1);
    EXPECT_TRUE(run["incipient_slip_s"].is_null());
    EXPECT_TRUE(run["slip_s"].is_null());
}

TEST(GelRun, anArmDrawsTheGelBackFromABump) {
    const auto run = measuresOf("gel-bump");
    EXPECT_EQ(run["stopped_without_bump"], 0);
    ASSERT_TRUE(run["bump_to_stop_s"].is_number());
    EXPECT_LE(run["bump_to_stop_s"].get<double>(), 0.051) << "three pictures";
    EXPECT_LT(run["deepest_m"].get<double>(), 0.002) << "half of what the ball would press";
}

TEST(GelRun, anArmFollowsWhatDragsTheGel) {
    const auto run = measuresOf("gel-follow");
    // The ball goes 12 mm along x and 6 mm along y.
    EXPECT_NEAR(run["followed_m"].get<double>(), std::hypot(0.012, 0.006), 0.001);
    EXPECT_LT(run["follow_error_m"].get<double>(), 0.001);
}

TEST(GelRun, writesItsFilesAndARecording) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/gel-slip.toml");
    ASSERT_TRUE(scene);
    const test::TemporaryFolder folder;
    RunOptions options;
    options.name = "gel-slip";
    options.duration_s = 2.0;
    options.outFolder = folder.path("run");
    ASSERT_TRUE(runScene(*scene, options));
    for (const char* file : {"summary.json", "markers.csv", "contacts.csv", "truth.csv", "recording.teleta"})
        EXPECT_TRUE(std::filesystem::exists(folder.path("run") + '/' + file)) << file;
    const std::string truth = test::readAll(folder.path("run/truth.csv"));
    EXPECT_TRUE(truth.starts_with("time_s,object,touches,x_m,y_m,radius_m")) << truth.substr(0, 80);
    // Five pictures are too few for the gel at rest.
    options.outFolder.clear();
    options.duration_s = 0.2;
    const auto tooShort = runScene(*scene, options);
    ASSERT_FALSE(tooShort);
    EXPECT_NE(core::describe(tooShort.error()).find("at least 8 pictures"), std::string::npos)
        << core::describe(tooShort.error());
}

} // namespace teleta::scene_run
