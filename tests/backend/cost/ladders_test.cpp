// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_result.h"
#include "backend/cost/ladders/ladder_camera.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/camera/nominal_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

using namespace teleta;
using namespace teleta::cost;

namespace {

Ladder ladderNamed(const std::string& name) {
    const std::vector<Ladder> ladders = allLadders();
    return *std::ranges::find(ladders, name, &Ladder::name);
}

/// Mean errors over the first trials, by rung.
std::map<std::string, double> meanErrors(const Ladder& ladder, std::size_t trials) {
    std::map<std::string, double> means;
    const core::Expected<std::vector<Rung>> rungs = ladder.makeRungs();
    EXPECT_TRUE(rungs);
    for (const Rung& rung : *rungs) {
        if (rung.name == kLimitName)
            continue;
        std::vector<double> errors;
        for (std::size_t i = 0; i < trials; ++i) {
            Trial trial(i);
            rung.run(trial);
            EXPECT_GT(trial.time_s(), 0.0) << rung.name;
            errors.insert(errors.end(), trial.errors().begin(), trial.errors().end());
        }
        EXPECT_TRUE(std::ranges::all_of(errors, [](double e) { return std::isfinite(e) && e >= 0.0; }))
            << rung.name;
        means[rung.name] =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    }
    return means;
}

/// Table, chart and JSON say how much longer the fastest rung takes than what cannot be left out.
void expectLimit(const Ladder& ladder, const std::vector<Rung>& rungs) {
    EXPECT_EQ(std::ranges::count(rungs, kLimitName, &Rung::name), 1) << ladder.name;
    EXPECT_EQ(rungs.back().name, kLimitName) << ladder.name;
    EXPECT_FALSE(rungs.back().parameter.empty()) << ladder.name;
    Trial trial(1);
    rungs.back().run(trial);
    EXPECT_TRUE(trial.errors().empty()) << ladder.name;
    EXPECT_GT(trial.time_s(), 0.0) << ladder.name;
}

} // namespace

TEST(Ladders, haveNamesOfTheirOwnAndAtLeastTwoRungs) {
    std::set<std::string> names;
    for (const Ladder& ladder : allLadders()) {
        EXPECT_TRUE(names.insert(ladder.name).second) << ladder.name;
        EXPECT_FALSE(ladder.title.empty() || ladder.truth.empty() || ladder.errorUnit.empty());
        EXPECT_TRUE(ladder.topic) << ladder.name;
        EXPECT_GE(ladder.trials, kFewestTrials);
    }
}

// A trial is timed again when others used the machine meanwhile; its errors must not depend on that.
TEST(Ladders, endWithALimitAndTheirTrialsHaveTheSameErrorsHoweverOftenAndInWhateverOrderTheyAreTimed) {
    for (const Ladder& ladder : allLadders()) {
        const core::Expected<std::vector<Rung>> inOrder = ladder.makeRungs();
        const core::Expected<std::vector<Rung>> repeated = ladder.makeRungs();
        ASSERT_TRUE(inOrder && repeated) << ladder.name;
        expectLimit(ladder, *inOrder);
        for (std::size_t r = 0; r < inOrder->size(); ++r) {
            if ((*inOrder)[r].name.ends_with("00000") || (*inOrder)[r].name.ends_with("10000") ||
                (*inOrder)[r].name == "bootstrap-2000")
                continue; // minutes under a sanitizer
            const auto errorsOf = [r](const std::vector<Rung>& rungs, std::size_t index) {
                Trial trial(index);
                rungs[r].run(trial);
                return trial.errors();
            };
            std::vector<std::vector<double>> expected;
            for (std::size_t i = 0; i < 3; ++i)
                expected.push_back(errorsOf(*inOrder, i));
            for (const std::size_t index : {0U, 0U, 1U, 2U, 2U, 1U})
                EXPECT_EQ(errorsOf(*repeated, index), expected[index])
                    << ladder.name << ' ' << (*inOrder)[r].name << ' ' << index;
        }
    }
}

// Without noise both methods are exact; with the noise s of a torque the paper's two samples at the borders
// of the window w are off by sqrt(2) s / w on average over many touches, which a regression over n samples
// divides by sqrt(n / 6) (variance of the slope of n even torques).
TEST(StiffnessLadder, regressionBeatsTwoPointsAsTheNumberOfSamplesGrows) {
    const auto errors = meanErrors(ladderNamed("stiffness"), 200);
    EXPECT_LT(errors.at("regression-1000"), 0.3 * errors.at("two-point-1000"));
    EXPECT_LT(errors.at("regression-1000"), 0.5 * errors.at("regression-30"));
    EXPECT_LT(errors.at("regression-1000"), 0.02);
    EXPECT_GT(errors.at("two-point-2"), 0.005) << "2.4 % of noise in the torque rise cannot vanish";
}

// An approximating spline draws a circle of n points with (2 + cos(2 pi / n)) / 3 of its radius: with 8
// points 9.8 % too small. An interpolating one goes through them.
TEST(ContourLadder, interpolatingIsNearerWithFewPointsAndApproximatingSmoothsTheNoiseOfMany) {
    const auto errors = meanErrors(ladderNamed("contour"), 90);
    EXPECT_LT(errors.at("interpolating-16"), 0.6 * errors.at("approximating-16"));
    EXPECT_LT(errors.at("approximating-360"), errors.at("interpolating-360"));
    EXPECT_LT(errors.at("interpolating-64"), 0.0003) << "the noise of a touch is 0.2 mm";
    EXPECT_GT(errors.at("approximating-8"), 0.001);
}

// A spark of 30 in 0.5 % of the readings adds 0.15 to every mean, which changes the ratios of taxels that
// differ by 20 %; with few frames some taxels have a spark and others none.
TEST(TaxelGainsLadder, aRobustFitIsNearerThanTheRatioOfMeansAndGainsByMoreFrames) {
    const auto errors = meanErrors(ladderNamed("taxel-gains"), 10);
    EXPECT_LT(errors.at("robust-50"), 0.2 * errors.at("ratio-of-means-50"));
    EXPECT_LT(errors.at("robust-1000"), 0.1 * errors.at("ratio-of-means-1000"));
    // Noise of 2 % over the square root of the frames, and what sparks add to it.
    EXPECT_LT(errors.at("robust-1000"), 0.002);
    EXPECT_LT(errors.at("robust-1000"), 0.4 * errors.at("robust-50"));
}

TEST(TactileFeaturesLadder, aSummitIsNearerThanACentroidWhereTheBorderCutsTheContact) {
    const auto errors = meanErrors(ladderNamed("tactile-features"), 8);
    EXPECT_LT(errors.at("weighted"), errors.at("binarised"));
    EXPECT_LT(errors.at("sub-taxel"), 0.8 * errors.at("weighted"));
    EXPECT_LT(errors.at("sub-taxel"), 0.1 * 0.0034) << "a tenth of the pitch";
}

// Two balls whose contacts run into each other are 14 to 20 mm from their common centroid. Noise puts a
// summit here and there on the ridge of a cylinder, and lets a taxel fire where nothing presses: of 10 000
// some do at 4 standard deviations, three neighbours never.
TEST(SkinContactsLadder, theUsualWatershedTellsContactsApartAndLeavesNoiseOutByItsSize) {
    const auto errors = meanErrors(ladderNamed("skin-contacts"), 16);
    EXPECT_LT(errors.at("watershed"), 0.7 * errors.at("connected"));
    EXPECT_LT(errors.at("watershed"), 0.7 * errors.at("every-summit"));
    EXPECT_LT(errors.at("watershed-3-taxels"), 0.5 * errors.at("watershed"));
    EXPECT_LT(errors.at("watershed-3-taxels"), 0.1 * 0.01) << "a tenth of the pitch";
    EXPECT_LT(errors.at("watershed-3-summit"), 0.3 * 0.01);
}

// The ball drags its markers by up to 0.85 of their distance, so that a picture alone takes some for their
// neighbours. A whole pixel is 0.38 px off on average. A place at rest from one picture has the noise of a
// place that is found, from eight a third of it: sqrt(2 / (1 + 1/8)) = 1.33 times the error.
TEST(GelMarkersLadder, followingKeepsMarkersApartAndMorePicturesAtRestPay) {
    const auto errors = meanErrors(ladderNamed("gel-markers"), 36);
    EXPECT_LT(errors.at("followed-8"), 0.1 * errors.at("centres"));
    EXPECT_LT(errors.at("centres"), errors.at("spots"));
    EXPECT_LT(errors.at("followed-8"), 0.95 * errors.at("followed-1"));
    EXPECT_LT(errors.at("followed-8"), 0.2 * 0.1e-3) << "a fifth of a pixel";
    EXPECT_GT(errors.at("spots"), 0.3 * 0.1e-3);
}

// The likelihood of 120 answers is no parabola, and flat where the slope is at its limit: the normal
// approximation is too short there, which the profile and the bootstrap know.
TEST(PsychometricFitLadder, theProfileHoldsTheThresholdWhereTheNormalApproximationDoesNot) {
    const core::Expected<std::vector<Rung>> rungs = ladderNamed("psychometric-fit").makeRungs();
    ASSERT_TRUE(rungs);
    std::map<std::string, double> scores;
    for (const Rung& rung : *rungs) {
        if (rung.name == kLimitName || rung.name == "bootstrap-2000")
            continue; // without an error, or minutes under a sanitizer
        for (std::size_t i = 0; i < 200; ++i) {
            Trial trial(i);
            rung.run(trial);
            scores[rung.name] += trial.errors().at(0) / 200.0;
        }
        EXPECT_GT(scores[rung.name], 0.0);
    }
    EXPECT_LE(scores.at("several-starts"), 1.01 * scores.at("one-start"));
    EXPECT_LT(scores.at("profile"), scores.at("grid"));
    EXPECT_LT(scores.at("profile"), 0.8 * scores.at("several-starts"));
    EXPECT_LT(scores.at("bootstrap-200"), 0.8 * scores.at("several-starts"));
}

TEST(UndistortionLadder, newtonIsExactAFixedNumberOfStepsIsNot) {
    const auto errors = meanErrors(ladderNamed("undistortion"), 8);
    EXPECT_LT(errors.at("newton"), 1e-12);
    EXPECT_LT(errors.at("table-8"), errors.at("table-32") / 8.0) << "the square of the step";
    EXPECT_LT(errors.at("table-8"), 1e-4);
    EXPECT_GT(errors.at("fixed-1"), 1e-3);
}

TEST(CameraCalibrationLadder, wrongPairsSpoilASquareFitAndNotARobustOne) {
    const auto errors = meanErrors(ladderNamed("camera-calibration"), 3);
    EXPECT_LT(errors.at("robust"), 0.001);
    EXPECT_LT(errors.at("robust"), 0.2 * errors.at("least_squares"));
    EXPECT_LT(errors.at("robust"), 0.2 * errors.at("dlt"));
}

// A step of first order: ten times the step, ten times the error.
TEST(SimulationStepLadder, errorsGrowWithTheStepInBothWays) {
    const auto errors = meanErrors(ladderNamed("simulation-step"), 50);
    EXPECT_NEAR(errors.at("implicit-1ms") / errors.at("implicit-0.1ms"), 10.0, 3.0);
    EXPECT_NEAR(errors.at("explicit-0.05ms") / errors.at("explicit-0.01ms"), 5.0, 1.5);
    EXPECT_GT(errors.at("implicit-10ms"), errors.at("implicit-2ms"));
}

TEST(SceneEffectsLadder, theSceneWithAllEffectsIsItsOwnTruthAndEachOneMovesIt) {
    const auto errors = meanErrors(ladderNamed("scene-effects"), 10);
    EXPECT_EQ(errors.at("all"), 0.0);
    // Over most taxels nothing presses, so noise alone is left there: half of 15 mN, rectified or not.
    EXPECT_GT(errors.at("without-noise"), 0.003);
    EXPECT_LT(errors.at("without-noise"), 0.02);
    EXPECT_GT(errors.at("without-crosstalk"), 0.0);
    EXPECT_GE(errors.at("none"), errors.at("without-noise"));
}

// Measured transfer is too high by (6-1)(6-1)/(2 * 180 ln 2) = 0.100 bit, half the width of its interval and
// more.
TEST(StatisticsLadder, takingTheBiasOffPays) {
    const core::Expected<std::vector<Rung>> rungs = ladderNamed("statistics").makeRungs();
    ASSERT_TRUE(rungs);
    std::map<std::string, double> scores;
    for (const Rung& rung : *rungs) {
        if (rung.name == kLimitName || rung.name.ends_with("00000") || rung.name.ends_with("10000"))
            continue; // without an error, or minutes under a sanitizer
        for (std::size_t i = 0; i < 40; ++i) {
            Trial trial(i);
            rung.run(trial);
            scores[rung.name] += trial.errors().at(0) / 40.0;
        }
    }
    EXPECT_LT(scores.at("asymptotic-miller"), scores.at("asymptotic"));
    EXPECT_LT(scores.at("asymptotic-jackknife"), scores.at("asymptotic"));
    EXPECT_LT(scores.at("asymptotic-occupied"), scores.at("asymptotic"));
    EXPECT_LT(scores.at("asymptotic-grassberger"), scores.at("asymptotic"));
    EXPECT_LT(scores.at("jackknife-participants"), scores.at("bootstrap-1000"));
    EXPECT_LT(scores.at("bootstrap-miller-1000"), scores.at("bootstrap-1000"));
    for (const auto& [name, score] : scores)
        EXPECT_GT(score, 0.0) << name;
}

// The finder's camera model is the renderer's, too: a mistake in it would cancel out. So what is behind each
// pixel of the rendered tube is compared with the projection that is written out once more.
TEST(ContactFlowLadder, theRenderedTubeIsWhereTheFormulaOfTheLensPutsIt) {
    scene::Scene scene;
    scene.duration_s = 1.0;
    scene.rate_Hz = 40.0;
    scene.world = scene::CameraWorld{};
    const auto lens = vision::nominalCamera(1640, 1232).camera().parameters().distortion;
    scene.effects.push_back(
        {"", scene::LensDistortionSpec{{lens.k1, lens.k2, lens.k3, lens.k4, lens.k5, lens.k6}, {}}});
    const auto tube = simulation::SimulatedTube::make(scene, 1);
    ASSERT_TRUE(tube) << core::describe(tube.error());
    const vision::CameraParameters& camera = (*tube)->camera().camera().parameters();
    const cv::Mat2f& places = (*tube)->renderer().places();
    int compared = 0;
    for (int row = 0; row < places.rows; row += 37) {
        for (int column = 0; column < places.cols; column += 37) {
            const cv::Vec2f place = places(row, column);
            if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
                continue;
            const Eigen::Vector2d pixel = exactPixel(camera, tubePoint_m(place[0], place[1]));
            EXPECT_NEAR(pixel.x(), column, 0.01) << row;
            EXPECT_NEAR(pixel.y(), row, 0.01) << column;
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(ContactFlowLadder, findsWhatWasRendered) {
    const core::Expected<std::vector<Rung>> rungs = ladderNamed("contact-flow").makeRungs();
    ASSERT_TRUE(rungs);
    EXPECT_GE(rungs->size(), 13U);
    const auto dots = std::ranges::find(*rungs, "dots", &Rung::name);
    ASSERT_NE(dots, rungs->end());
    for (std::size_t i = 0; i < kFewestTrials; i += 3) {
        Trial trial(i);
        dots->run(trial);
        ASSERT_EQ(trial.errors().size(), 1U);
        EXPECT_LT(trial.errors()[0], 0.002) << i;
    }
}
