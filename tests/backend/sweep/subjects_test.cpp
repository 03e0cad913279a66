// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/base/flat_measures.h"
#include "backend/scene_run/scene_run.h"
#include "backend/study/planning/identification_plan.h"
#include "backend/sweep/frame_parts.h"
#include "backend/sweep/sweep_results.h"
#include "backend/sweep/sweep_runner.h"
#include "backend/sweep/sweep_subject.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace teleta;
using test::TemporaryFolder;

namespace {

const std::string kScenes = TELETA_SOURCE_DIR "/resources/scenes/";

sweep::SubjectSources sources() {
    return {[](const std::string& name) { return core::readFile(kScenes + name + ".toml"); },
            cost::allLadders()};
}

sweep::SweepPlan planOf(const std::string& text, const std::string& file = "a.toml") {
    auto plan = sweep::parseSweepPlan(text, file);
    EXPECT_TRUE(plan) << describe(plan.error());
    return plan ? *plan : sweep::SweepPlan{};
}

core::Error errorOf(sweep::SweepPlan plan) {
    const auto subject = sweep::makeSubject(plan, sources());
    EXPECT_FALSE(subject);
    return subject ? core::Error{} : subject.error();
}

} // namespace

TEST(SweptScene, isTheSceneWithOtherValues) {
    sweep::SweepPlan plan =
        planOf("[sweep]\nscene = \"tactile-indenter\"\nseeds = \"5\"\n[sweep.vary]\n"
               "\"indenter.ball.radius_m\" = [0.012, 0.009]\n\"effect.noise.sd_N\" = [0.05]\n"
               "duration_s = [2.0]\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    const auto measures = (*subject)->makeWorker()->run(plan, 1, 5, {});
    ASSERT_TRUE(measures) << describe(measures.error());

    // The same scene, changed by hand.
    auto scene = scene::readScene(kScenes + "tactile-indenter.toml");
    ASSERT_TRUE(scene);
    std::get<scene::Sphere>(scene->array().indenters[0].shape).radius_m = 0.009;
    for (scene::Effect& effect : scene->effects)
        if (auto* noise = std::get_if<scene::NoiseSpec>(&effect.parameters))
            noise->sd_N = 0.05;
    const auto summary = scene_run::runScene(*scene, {.name = {},
                                                      .seed = 5,
                                                      .duration_s = 2.0,
                                                      .outFolder = {},
                                                      .sceneText = {},
                                                      .goOn = {},
                                                      .onFrame = {}});
    ASSERT_TRUE(summary);
    EXPECT_EQ(*measures, scene_run::flatMeasures(summary->measures).numbers);
}

TEST(SweptScene, hasMeasuresThatItsFirstRunCannotDetermine) {
    // A force error has no value before the array slides, and yet the name is right.
    sweep::SweepPlan plan = planOf("[sweep]\nscene = \"servo-bent-bar\"\nmeasures = [\"force_rms_error_n\"]\n"
                                   "[sweep.vary]\nduration_s = [0.2, 4.0]\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    const TemporaryFolder folder;
    sweep::SweepOptions options;
    options.folder = folder.path("out");
    options.workers = 1;
    ASSERT_TRUE(sweep::runSweep(plan, **subject, options));
    const auto results = sweep::readResults(plan, options.folder);
    ASSERT_TRUE(results);
    ASSERT_EQ(results->measures, (std::vector<std::string>{"force_rms_error_n"}));
    EXPECT_EQ(results->cells[0].measures[0].n, 0U);
    EXPECT_EQ(results->cells[1].measures[0].n, 1U);
}

TEST(SweptScene, canHaveAnEffectThatTheFileDoesNotList) {
    sweep::SweepPlan plan = planOf("[sweep]\nscene = \"servo-bent-bar\"\n[sweep.vary]\n"
                                   "\"effect.friction.coefficient\" = [0.3]\nduration_s = [1.0]\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    const auto measures = (*subject)->makeWorker()->run(plan, 0, 1, {});
    ASSERT_TRUE(measures);
    // A second is too short for the task.
    EXPECT_TRUE(std::ranges::find(*measures, std::pair<std::string, double>("completed", 0.0)) !=
                measures->end());
}

TEST(SweptScene, isRefusedAtTheKeyOfTheSweepFile) {
    const core::Error unknown = errorOf(planOf(
        "[sweep]\nscene = \"teleta-touch\"\n[sweep.vary]\nduration_s = [3.0]\n\"skin.pitch_mm\" = [9]\n"));
    EXPECT_EQ(unknown.where.line, 5);
    EXPECT_NE(unknown.message.find("pitch_mm"), std::string::npos);
    const core::Error range =
        errorOf(planOf("[sweep]\nscene = \"teleta-touch\"\n[sweep.vary]\n"
                       "\"object.2.radius_m\" = [0.02, 0.03,\n -1.0]\nduration_s = [3.0, 4.0]\n"));
    EXPECT_EQ(range.where.line, 4);
    EXPECT_NE(range.message.find("object.2.radius_m = -1"), std::string::npos) << range.message;
    EXPECT_EQ(
        errorOf(planOf("[sweep]\nscene = \"teleta-touch\"\n[sweep.vary]\n\"object.7.radius_m\" = [0.02]\n"))
            .where.line,
        4);
    EXPECT_EQ(errorOf(planOf("[sweep]\nscene = \"no-such-scene\"\n")).kind, core::ErrorKind::notFound);
}

TEST(SweptLadder, runsEveryRungOnTheSameTrials) {
    sweep::SweepPlan plan = planOf("[sweep]\nladder = \"contour\"\nseeds = \"1:3\"\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    const auto rungs = cost::contourLadder().makeRungs();
    ASSERT_TRUE(rungs);
    EXPECT_EQ(plan.cells() + 1, rungs->size()) << "the limit has no error to sweep over";
    const auto worker = (*subject)->makeWorker();
    const auto measures = worker->run(plan, 2, 1, {});
    ASSERT_TRUE(measures);
    cost::Trial trial(1);
    (*rungs)[2].run(trial);
    double error = 0.0;
    for (const double each : trial.errors())
        error += each / static_cast<double>(trial.errors().size());
    EXPECT_EQ(measures->front().first, "error");
    EXPECT_NEAR(measures->front().second, error, 1e-12 * error);
    EXPECT_NE(errorOf(planOf("[sweep]\nladder = \"stairs\"\n")).expected.find("contour"), std::string::npos);
    EXPECT_EQ(errorOf(planOf("[sweep]\nladder = \"contour\"\n[sweep.vary]\nrung = [\"none\"]\n")).where.line,
              4);
}

TEST(SweptStudy, countsAsThePlanOfTheStudyDoes) {
    const TemporaryFolder folder;
    folder.write("truth.toml", R"([[task]]
id = "shape"
participant_sd = 0.5
participant_condition_sd = 0.3
[[task.condition]]
id = "static"
correct = 0.70
[[task.condition]]
id = "dynamic"
correct = 0.80
)");
    const std::string text =
        "[sweep]\nstudy = \"teleta\"\ntruth = \"truth.toml\"\ntest = \"shape:condition\"\n"
        "participants = 8\nseeds = \"0:299\"\n";
    const std::string file = folder.write("sweep.toml", text);
    sweep::SweepPlan plan = planOf(text, file);
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    sweep::SweepOptions options;
    options.folder = folder.path("out");
    ASSERT_TRUE(sweep::runSweep(plan, **subject, options));
    const auto results = sweep::readResults(plan, options.folder);
    ASSERT_TRUE(results);
    ASSERT_EQ(results->measures.front(), "significant");

    const auto truth = study::readTruth(folder.path("truth.toml"));
    ASSERT_TRUE(truth);
    const auto possible = study::IdentificationPlan::make(*study::paperProtocol(), *truth, "shape:condition");
    ASSERT_TRUE(possible) << describe(possible.error());
    study::PlanSettings settings;
    settings.participants = {8};
    settings.studies = settings.mostStudies = 300;
    const study::PowerPlan power = study::planPower(*possible, settings);
    EXPECT_EQ(power.points[0].studies, 300U);
    EXPECT_DOUBLE_EQ(*results->cells[0].measures[0].mean, power.points[0].power());
    EXPECT_NEAR(*results->cells[0].measures[0].low95, power.points[0].interval().low, 1e-12);
}

TEST(SweptFrames, knowWhereAndHowHardABallPresses) {
    sweep::SweepPlan plan = planOf("[sweep]\nscene = \"tactile-two-contacts\"\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject);
    EXPECT_TRUE((*subject)->hasFrames());
    std::size_t frames = 0;
    std::set<std::pair<int, int>> contacts;
    double largest_N = 0.0;
    const auto measures =
        (*subject)->makeWorker()->run(plan, 0, 1, [&](const scene_run::LabelledFrame& frame) {
            ++frames;
            EXPECT_EQ(frame.values.size(), 84U);
            for (const scene_run::ContactLabel& contact : frame.contacts) {
                contacts.insert({contact.object, contact.identity});
                // Not beside the array.
                EXPECT_LT(std::abs(contact.x_m), 7 * 0.0034);
                EXPECT_LT(std::abs(contact.y_m), 3 * 0.0034);
                EXPECT_EQ(contact.normal, (std::array<double, 3>{0.0, 0.0, 1.0}));
                largest_N = std::max(largest_N, contact.force_N);
            }
        });
    ASSERT_TRUE(measures);
    EXPECT_EQ(frames, 3200U);
    // Each ball presses once.
    EXPECT_EQ(contacts.size(), 2U);
    // Of a foundation: k / pitch^2 pi d^2 (R - d/3), at the largest depth of 2 mm of the ball of 5.2 mm.
    const double depth_m = 0.002;
    const double force_N =
        1200.0 / (0.0034 * 0.0034) * 3.14159265 * depth_m * depth_m * (0.0052 - depth_m / 3.0);
    EXPECT_NEAR(largest_N, force_N, 0.02 * force_N);
}

TEST(SweptFrames, ofAServoHaveTheNormalOfTheObject) {
    sweep::SweepPlan plan =
        planOf("[sweep]\nscene = \"servo-straight-bar\"\n[sweep.vary]\nduration_s = [4.0]\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    std::size_t touched = 0;
    ASSERT_TRUE((*subject)->makeWorker()->run(plan, 0, 1, [&](const scene_run::LabelledFrame& frame) {
        for (const scene_run::ContactLabel& contact : frame.contacts) {
            ++touched;
            const auto& n = contact.normal;
            EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1e-9);
            // The bar looks at the array, which presses it nearly straight.
            EXPECT_LT(n[2], -0.9);
        }
    }));
    EXPECT_GT(touched, 100U);
}

// The bar falls away and turns aside, and the array follows it late: the normal in its frame is not the same.
TEST(SweptFrames, ofTheShippedSweepOfAServoHaveManyNormalsAndAreAMillion) {
    auto plan = sweep::readSweepPlan(TELETA_SOURCE_DIR "/resources/sweeps/labelled-servo-frames.toml");
    ASSERT_TRUE(plan) << describe(plan.error());
    const auto subject = sweep::makeSubject(*plan, sources());
    ASSERT_TRUE(subject) << describe(subject.error());
    EXPECT_TRUE((*subject)->hasFrames());
    std::size_t frames = 0;
    double lowest = 1.0, highest = -1.0;
    const auto measures =
        (*subject)->makeWorker()->run(*plan, 0, plan->seedOf(0), [&](const scene_run::LabelledFrame& frame) {
            ++frames;
            for (const scene_run::ContactLabel& contact : frame.contacts) {
                lowest = std::min(lowest, contact.normal[1]);
                highest = std::max(highest, contact.normal[1]);
            }
        });
    ASSERT_TRUE(measures) << describe(measures.error());
    EXPECT_GE(frames * plan->runs(), 1'000'000U);
    EXPECT_GT(highest - lowest, 0.02) << "a degree";
}

TEST(SweptFrames, areOnlyOfArrays) {
    sweep::SweepPlan plan = planOf("[sweep]\nscene = \"teleta-touch\"\n");
    const auto subject = sweep::makeSubject(plan, sources());
    ASSERT_TRUE(subject);
    EXPECT_FALSE((*subject)->hasFrames());
    const TemporaryFolder folder;
    sweep::SweepOptions options;
    options.folder = folder.path("out");
    options.frames = true;
    EXPECT_FALSE(sweep::runSweep(plan, **subject, options));
}
