// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/scene_run/study/stimulus_bracelet.h"
#include "backend/scene_run/study/study_run.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

namespace teleta::scene_run {

namespace {

study::StudyScene shipped() {
    const std::string path = TELETA_SOURCE_DIR "/resources/scenes/study-rehearsal.toml";
    return study::parseStudyScene(test::readAll(path), path).value();
}

SceneSummary run(const study::StudyScene& scene, std::uint64_t seed, const std::string& folder = {}) {
    RunOptions options;
    options.name = "study-rehearsal";
    options.seed = seed;
    options.outFolder = folder;
    auto summary = runStudyScene(scene, options);
    EXPECT_TRUE(summary) << core::describe(summary.error());
    return *summary;
}

} // namespace

TEST(StudyRun, goesThroughTheWholeStudyOfThePaper) {
    const test::TemporaryFolder folder;
    const SceneSummary summary = run(shipped(), 1, folder.path("out"));
    EXPECT_EQ(summary.measures["trials"], 110);
    EXPECT_EQ(summary.measures["patterns_sent"], 2 * 18 + 2 * 15 + 110);
    EXPECT_EQ(summary.effects.size(), 6U);
    EXPECT_FALSE(summary.interrupted);
    // 176 trials of at least the stimulus and the second between two of them.
    EXPECT_GT(summary.simulated_s, 176 * 2.0);
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/summary.json")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/study.sqlite")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/data/subject-P01")));
    RunOptions again;
    again.outFolder = folder.path("out");
    EXPECT_EQ(runStudyScene(shipped(), again).error().kind, core::ErrorKind::refused)
        << "nothing is overwritten";
}

TEST(StudyRun, isTheSameForTheSameSeed) {
    const test::TemporaryFolder folder;
    const SceneSummary a = run(shipped(), 5, folder.path("a"));
    const SceneSummary b = run(shipped(), 5, folder.path("b"));
    EXPECT_EQ(a.measures, b.measures);
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("a/data"))) {
        if (entry.path().extension() == ".csv")
            files.insert(std::filesystem::relative(entry.path(), folder.path("a")).string());
    }
    EXPECT_EQ(files.size(), 4U);
    for (const std::string& file : files)
        EXPECT_EQ(test::readAll(folder.path("a/" + file)), test::readAll(folder.path("b/" + file))) << file;
    EXPECT_NE(run(shipped(), 6).measures, a.measures);
}

TEST(StudyRun, endsAtItsTimeAndWhenItIsAskedTo) {
    RunOptions options;
    options.duration_s = 60.0;
    const auto shortened = runStudyScene(shipped(), options);
    ASSERT_TRUE(shortened);
    EXPECT_GE(shortened->simulated_s, 60.0);
    EXPECT_LT(shortened->simulated_s, 60.0 + 12.0) << "a trial lasts at most its limit and the pause";
    EXPECT_FALSE(shortened->interrupted);
    options.goOn = [](double simulated_s, double) { return simulated_s < 20.0; };
    const auto stopped = runStudyScene(shipped(), options);
    ASSERT_TRUE(stopped);
    EXPECT_TRUE(stopped->interrupted);
}

TEST(StimulusBracelet, withoutEffectsItFeelsWhatIsTold) {
    study::StudyScene scene = shipped();
    for (const char* effect : {"motor_lag", "dead_zone", "dropped_frames"})
        scene = scene.without(effect);
    EffectTimes times_ns;
    StimulusBracelet bracelet(scene, times_ns);
    const auto shown = bracelet.show(*pattern::findBuiltIn("shape.A.static"), 2.0, 1);
    EXPECT_EQ(shown.frames, 400U);
    EXPECT_EQ(shown.lost, 0U);
    EXPECT_EQ(bracelet.rmsError(), 0.0);
    ASSERT_EQ(bracelet.onsets_s().size(), 1U);
    EXPECT_EQ(bracelet.onsets_s()[0], 0.0);
}

// A first-order motor with a rise time (0 to 90 %) of T is at half after T log10(2).
TEST(StimulusBracelet, aMotorThatLagsIsFeltAfterItsRise) {
    study::StudyScene scene = shipped().without("dropped_frames").without("dead_zone");
    scene.motorLag = study::StudyScene::MotorLag{0.200, 0.200};
    EffectTimes times_ns;
    StimulusBracelet bracelet(scene, times_ns);
    (void)bracelet.show(*pattern::findBuiltIn("shape.A.static"), 2.0, 1);
    ASSERT_EQ(bracelet.onsets_s().size(), 1U);
    EXPECT_NEAR(bracelet.onsets_s()[0], 0.200 * std::log10(2.0), 1.0 / scene.frameRate_Hz + 1e-12);
}

TEST(StimulusBracelet, losesTheShareOfFramesThatItIsTold) {
    study::StudyScene scene = shipped();
    scene.droppedFrames = 0.1;
    EffectTimes times_ns;
    StimulusBracelet bracelet(scene, times_ns);
    std::size_t lost = 0;
    std::size_t frames = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const auto shown = bracelet.show(*pattern::findBuiltIn("shape.C.dynamic"), 2.0, seed);
        lost += shown.lost;
        frames += shown.frames;
    }
    EXPECT_NEAR(static_cast<double>(lost), 0.1 * static_cast<double>(frames),
                5.0 * std::sqrt(0.09 * static_cast<double>(frames)));
}

} // namespace teleta::scene_run
