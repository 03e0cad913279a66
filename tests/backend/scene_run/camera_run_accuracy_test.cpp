// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <iostream>
#include <string>

namespace teleta::scene_run {
namespace {

class CameraRun : public testing::TestWithParam<std::uint64_t> {
protected:
    nlohmann::ordered_json measures(const std::string& name, RunOptions options = {}) {
        const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
        EXPECT_TRUE(scene) << describe(scene.error());
        options.name = name;
        options.seed = GetParam();
        const auto summary = runScene(*scene, options);
        EXPECT_TRUE(summary) << describe(summary.error());
        EXPECT_EQ(summary->effects.size(), scene->effects.size());
        std::cout << name << ": " << summary->measures.dump() << '\n';
        return summary->measures;
    }
};

} // namespace

TEST_P(CameraRun, stopsWithinTwoFramesOfABump) {
    const auto run = measures("vtacarm-bump");
    ASSERT_TRUE(run["bump_to_stop_s"].is_number());
    EXPECT_LE(run["bump_to_stop_s"].get<double>(), 2.0 / 40.0 + 1e-9);
    EXPECT_EQ(run["stopped_without_bump"], 0);
    EXPECT_EQ(run["frames_lost"], 0);
}

TEST_P(CameraRun, turnsAfterAFinger) {
    const auto run = measures("vtacarm-follow-turn");
    EXPECT_LT(run["follow_angle_error_rad"].get<double>(), 0.03);
    EXPECT_LT(run["follow_axial_error_m"].get<double>(), 0.002);
}

TEST_P(CameraRun, movesAlongAfterAFinger) {
    const auto run = measures("vtacarm-follow-axial");
    EXPECT_LT(run["follow_angle_error_rad"].get<double>(), 0.03);
    EXPECT_LT(run["follow_axial_error_m"].get<double>(), 0.002);
}

TEST_P(CameraRun, findsThreeFingersAtOnce) {
    const auto run = measures("vtacarm-multicontact");
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), 0.001);
    EXPECT_LT(run["contact_error_p95_m"].get<double>(), 0.0025);
    EXPECT_EQ(run["contacts_missed"], 0);
}

TEST_P(CameraRun, calibratesTheCameraFromWhatAPersonProbes) {
    // Two fifths of the places, those near the lens.
    RunOptions options;
    options.duration_s = 100.0;
    const auto run = measures("vtacarm-calibration", options);
    EXPECT_GE(run["pairs"].get<int>(), 80);
    EXPECT_GT(run["pairs_mistaken"].get<int>(), 0);
    EXPECT_EQ(run["mistaken_kept"], 0);
    EXPECT_EQ(run["not_located"], 0);
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), 0.001);
    EXPECT_EQ(run["frames_lost"], 0);
}

TEST_P(CameraRun, withoutACalibrationHasNoneOfItsMeasuresAndSaysWhy) {
    RunOptions options;
    options.duration_s = 3.0;
    const auto run = measures("vtacarm-calibration", options);
    for (const char* name : {"contact_error_mean_m", "contact_error_p95_m", "not_located", "uncertainty_m",
                             "pairs_kept", "mistaken_kept", "right_dropped"})
        EXPECT_TRUE(run.contains(name) && run[name].is_null()) << name;
    EXPECT_FALSE(run["refusal"].get<std::string>().empty());
}

INSTANTIATE_TEST_SUITE_P(Seeds, CameraRun, testing::Values(1));

TEST(CameraRunFiles, areWritten) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/vtacarm-bump.toml");
    ASSERT_TRUE(scene);
    const test::TemporaryFolder folder;
    RunOptions options;
    options.duration_s = 0.7;
    options.outFolder = folder.path("run");
    ASSERT_TRUE(runScene(*scene, options));
    for (const char* file : {"contacts.csv", "arm.csv", "reference.png", "summary.json"})
        EXPECT_GT(std::filesystem::file_size(options.outFolder + "/" + file), 100U) << file;
}

} // namespace teleta::scene_run
