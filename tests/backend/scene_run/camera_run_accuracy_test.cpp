// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::scene_run {
namespace {

class CameraRun : public testing::TestWithParam<std::uint64_t> {
protected:
    static tl::expected<scene::Scene, core::Error> shipped(const std::string& name) {
        auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
        EXPECT_TRUE(scene) << describe(scene.error());
        return scene;
    }
    nlohmann::ordered_json measures(const std::string& name, RunOptions options = {}) {
        return measures(shipped(name), name, std::move(options));
    }
    nlohmann::ordered_json measures(const tl::expected<scene::Scene, core::Error>& scene,
                                    const std::string& name, RunOptions options = {}) {
        options.name = name;
        options.seed = GetParam();
        const auto summary = runScene(*scene, options);
        EXPECT_TRUE(summary) << describe(summary.error());
        EXPECT_EQ(summary->effects.size(), scene->effects.size());
        std::cout << name << ": " << summary->measures.dump() << '\n';
        return summary->measures;
    }
};

/// Between keyframes a straight line: nearly the finger's path.
Eigen::Vector3d placeOf_m(const scene::Finger& finger, double time_s) {
    constexpr double kRadius_m = 0.025;
    const auto next = std::ranges::lower_bound(finger.keyframes, time_s, {}, &scene::FingerKeyframe::time_s);
    const scene::FingerKeyframe& to = next == finger.keyframes.end() ? finger.keyframes.back() : *next;
    const scene::FingerKeyframe& from = next == finger.keyframes.begin() ? to : *std::prev(next);
    const double share =
        to.time_s > from.time_s ? std::min(1.0, (time_s - from.time_s) / (to.time_s - from.time_s)) : 1.0;
    const double angle_rad = std::lerp(from.angle_rad, to.angle_rad, share);
    return {kRadius_m * std::cos(angle_rad), kRadius_m * std::sin(angle_rad),
            std::lerp(from.z_m, to.z_m, share)};
}

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

TEST_P(CameraRun, givesEachOfThreeFingersOneIdentityAndFindsNothingElse) {
    const auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/vtacarm-multicontact.toml");
    ASSERT_TRUE(scene);
    const std::vector<scene::Finger>& fingers = scene->camera().fingers;
    const test::TemporaryFolder folder;
    RunOptions options;
    options.outFolder = folder.path("run");
    static_cast<void>(measures("vtacarm-multicontact", options));
    auto rows = core::CsvReader::open(options.outFolder + "/contacts.csv");
    ASSERT_TRUE(rows);
    constexpr double kNear_m = 0.006; // the fingers are 30 mm apart
    std::map<double, std::set<std::size_t>> fingersOf;
    std::map<double, std::string> eventsOf;
    std::map<double, std::size_t> contactsIn;
    std::vector<std::string_view> fields;
    for (auto more = rows->nextText(fields); more && *more; more = rows->nextText(fields)) {
        const auto number = [&](std::size_t column) { return std::stod(std::string(fields[column])); };
        const double time_s = number(1);
        const double id = number(2);
        const Eigen::Vector3d place_m(number(5), number(6), number(7));
        if (fields[12] != "NA")
            eventsOf[id] += std::string(fields[12]) + " ";
        if (fields[12] == "end")
            continue;
        EXPECT_LE(++contactsIn[time_s], fingers.size()) << time_s;
        std::optional<std::size_t> finger;
        for (std::size_t i = 0; i < fingers.size(); ++i)
            if ((placeOf_m(fingers[i], time_s) - place_m).norm() < kNear_m)
                finger = i;
        EXPECT_TRUE(finger) << "a contact where nothing presses at " << time_s << " s, "
                            << place_m.transpose();
        if (finger)
            fingersOf[id].insert(*finger);
    }
    ASSERT_EQ(fingersOf.size(), fingers.size());
    std::set<std::size_t> all;
    for (const auto& [id, mine] : fingersOf) {
        EXPECT_EQ(mine.size(), 1U) << "contact " << id << " goes from finger to finger";
        all.insert(mine.begin(), mine.end());
        EXPECT_EQ(eventsOf[id], "begin end ") << id;
    }
    EXPECT_EQ(all.size(), fingers.size());
}

TEST_P(CameraRun, calibratesTheCameraFromWhatAPersonProbes) {
    // Two fifths of the rings, over the whole length.
    auto scene = shipped("vtacarm-calibration");
    ASSERT_TRUE(scene && scene->camera().probing);
    scene->camera().probing->along = 4;
    RunOptions options;
    options.duration_s = 100.0;
    const auto run = measures(scene, "vtacarm-calibration", options);
    EXPECT_GE(run["pairs"].get<int>(), 80);
    EXPECT_GT(run["pairs_mistaken"].get<int>(), 0);
    EXPECT_EQ(run["mistaken_kept"], 0);
    EXPECT_EQ(run["not_located"], 0);
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), 0.001);
    EXPECT_EQ(run["frames_lost"], 0);
}

TEST_P(CameraRun, knowsThatNearRingsAloneDoNotShowTheFarEnd) {
    RunOptions options;
    options.duration_s = 100.0;
    const auto run = measures("vtacarm-calibration", options);
    EXPECT_EQ(run["mistaken_kept"], 0);
    EXPECT_EQ(run["not_located"], 0);
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), run["uncertainty_m"].get<double>());
    EXPECT_LT(run["contact_error_mean_m"].get<double>(), 0.001);
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
