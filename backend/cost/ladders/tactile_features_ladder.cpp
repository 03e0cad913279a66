// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/summit.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/simulation/array/foundation_contact.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <numeric>

namespace teleta::cost {

namespace {

using Centre = Eigen::Vector2d;

constexpr std::size_t kFramesPerTrial = 64;
constexpr std::size_t kPressedFrames = 512;
constexpr double kActiveFrom_N = 0.2;

struct PressedFrame {
    std::vector<float> load_N;
    Centre centre_m = Centre::Zero();
};

/// A ball of 12 mm anywhere on the array, its lowest point at least one taxel inside of the border, so that
/// its contact may reach beyond; noise, and a taxel fires from 0.2 N on.
std::vector<PressedFrame> pressedFrames(const core::ArrayLayout& layout) {
    core::RandomStream random(1, "tactile features ladder");
    constexpr double kTaxelStiffness_NPerM = 1200.0;
    constexpr double kReadingNoise_N = 0.015;
    simulation::FoundationContact foundation(layout, kTaxelStiffness_NPerM);
    std::vector<PressedFrame> frames(kPressedFrames);
    std::vector<double> load_N(layout.taxels());
    for (PressedFrame& frame : frames) {
        const double x_m = (random.uniform() - 0.5) * layout.pitchX_m * (layout.columns - 2);
        const double y_m = (random.uniform() - 0.5) * layout.pitchY_m * (layout.rows - 2);
        std::array<simulation::RigidIndenter, 1> ball{simulation::RigidIndenter(scene::Sphere{0.012})};
        ball[0].moveTo({x_m, y_m, 0.0006 + 0.0012 * random.uniform(), 0.0});
        std::array<simulation::IndenterLoad, 1> loads;
        foundation.press(ball, load_N, loads);
        frame.centre_m = {x_m, y_m};
        for (const double load : load_N)
            frame.load_N.push_back(
                load < kActiveFrom_N
                    ? 0.0F
                    : static_cast<float>(std::max(0.0, load + kReadingNoise_N * random.normal())));
    }
    return frames;
}

struct FeatureInput {
    core::ArrayLayout layout;
    std::vector<PressedFrame> frames;
};

Rung featureRung(
    const char* name, const char* parameter, const std::shared_ptr<const FeatureInput>& input,
    const contact::FeatureSettings& settings,
    const std::function<Centre(const contact::TactileFeatures&, std::span<const float>)>& centreOf) {
    auto run = [=, extractor = contact::FeatureExtractor(input->layout, settings)](Trial& trial) mutable {
        std::array<Centre, kFramesPerTrial> centres;
        const std::size_t first = trial.index() * kFramesPerTrial;
        const auto frameAt = [&](std::size_t i) -> const PressedFrame& {
            return input->frames[(first + i) % input->frames.size()];
        };
        trial.timed(kFramesPerTrial, [&] {
            for (std::size_t i = 0; i < kFramesPerTrial; ++i) {
                const PressedFrame& frame = frameAt(i);
                centres[i] = centreOf(extractor.compute(frame.load_N), frame.load_N);
            }
        });
        for (std::size_t i = 0; i < kFramesPerTrial; ++i)
            trial.error((centres[i] - frameAt(i).centre_m).norm());
    };
    return {name, parameter, std::move(run)};
}

} // namespace

Ladder tactileFeaturesLadder() {
    Ladder ladder;
    ladder.name = "tactile-features";
    ladder.topic = Topic::tactileArray;
    ladder.title = LadderText::tr("Place of a contact on a tactile array").toStdString();
    ladder.truth = LadderText::tr("distance from the lowest point of the ball that presses").toStdString();
    ladder.errorUnit = "m";
    ladder.trials = 64;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const core::ArrayLayout layout;
        const auto input = std::make_shared<const FeatureInput>(FeatureInput{layout, pressedFrames(layout)});
        contact::FeatureSettings binarised;
        binarised.threshold_N = kActiveFrom_N;
        contact::FeatureSettings weighted = binarised;
        weighted.orientation = contact::OrientationMode::weighted;
        const auto pressure = [](const contact::TactileFeatures& features) {
            return Centre(features.copX_m.value_or(0.0), features.copY_m.value_or(0.0));
        };
        return std::vector<Rung>{
            featureRung("binarised", "centroid of the active taxels", input, binarised,
                        [](const contact::TactileFeatures& features, std::span<const float>) {
                            return Centre(features.cocX_m.value_or(0.0), features.cocY_m.value_or(0.0));
                        }),
            featureRung("weighted", "centre of pressure", input, weighted,
                        [=](const contact::TactileFeatures& features, std::span<const float>) {
                            return pressure(features);
                        }),
            featureRung("sub-taxel", "summit of a paraboloid", input, weighted,
                        [=](const contact::TactileFeatures& features, std::span<const float> load_N) {
                            const auto summit = contact::summitOf(load_N, layout, kActiveFrom_N);
                            return summit ? Centre(summit->x_m, summit->y_m) : pressure(features);
                        }),
            limitRung("each taxel read once", kFramesPerTrial, [=](std::size_t index) {
                const std::vector<float>& load_N = input->frames[index % input->frames.size()].load_N;
                return static_cast<double>(std::accumulate(load_N.begin(), load_N.end(), 0.0F));
            })};
    };
    return ladder;
}

} // namespace teleta::cost
