// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of the simulated tube in the size of the paper's camera while three fingers press (the shipped
// scene at its middle): the renderer against a plain implementation that follows every pixel that the presses
// can reach through the whole depth of the skin. Further rows: the shipped scene with all its effects, and
// without each of them. One core. Counter: pictures per second.
#include "backend/scene/scene_reader.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "tests/backend/simulation/camera/plain_skin_renderer.h"

#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace teleta;

/// All fingers touch.
constexpr double kMiddle_s = 2.0;

scene::Scene shipped() {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/vtacarm-multicontact.toml");
    if (!scene)
        throw std::runtime_error(core::describe(scene.error()));
    return std::move(*scene);
}

std::unique_ptr<simulation::SimulatedTube> tubeOf(const scene::Scene& scene) {
    auto tube = simulation::SimulatedTube::make(scene, 1);
    if (!tube)
        throw std::runtime_error(core::describe(tube.error()));
    return std::move(*tube);
}

/// The tube, and its fingers as they are in the middle of the scene.
struct Pressed {
    scene::CameraSkin skin = shipped().camera().skin;
    std::unique_ptr<simulation::SimulatedTube> tube = tubeOf(shipped());
    simulation::SkinDeformation deformation{skin.radius_m, skin.reach_m};
    simulation::SkinRenderer renderer{tube->camera(), skin, tube->renderer().dots()};
    std::vector<cv::Rect> parts;
    cv::Mat1f image;

    Pressed() {
        cv::setNumThreads(1);
        cv::Mat1b frame;
        while (tube->time_s() < kMiddle_s)
            tube->next({}, frame);
        std::vector<simulation::SkinPress> presses;
        for (const simulation::FingerTruth& finger : tube->truth())
            presses.push_back(finger.press);
        deformation.set(presses);
        parts = renderer.reach(deformation);
        image = renderer.atRest().clone();
    }
};

Pressed& pressed() {
    static Pressed made;
    return made;
}

void countPictures(benchmark::State& state) {
    state.counters["fps"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void drawPlainly(benchmark::State& state) {
    Pressed& scene = pressed();
    constexpr int kMarchSteps = 8;
    const test::PlainSkinRenderer plain(scene.renderer, scene.skin, kMarchSteps);
    cv::Rect all;
    for (const cv::Rect& part : scene.parts)
        all = all.empty() ? part : all | part;
    for (auto _ : state)
        plain.draw(scene.deformation, all, scene.image);
    countPictures(state);
}

void draw(benchmark::State& state) {
    Pressed& scene = pressed();
    for (auto _ : state)
        for (const cv::Rect& part : scene.parts)
            scene.renderer.draw(scene.deformation, part, scene.image);
    countPictures(state);
}

/// The whole scene from beginning to end, one picture per iteration.
void runScene(benchmark::State& state, bool withNoise) {
    cv::setNumThreads(1);
    scene::Scene scene = shipped();
    if (!withNoise)
        std::erase_if(scene.effects, [](const auto& effect) { return nameOf(effect) == "sensor_noise"; });
    const auto tube = tubeOf(scene);
    cv::Mat1b frame;
    for (auto _ : state) {
        tube->next({}, frame);
        benchmark::DoNotOptimize(frame.data);
    }
    countPictures(state);
}

} // namespace

BENCHMARK(drawPlainly)->Unit(benchmark::kMillisecond);
BENCHMARK(draw)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(runScene, as_it_is_shipped, true)->Unit(benchmark::kMillisecond)->Iterations(160);
BENCHMARK_CAPTURE(runScene, without_noise, false)->Unit(benchmark::kMillisecond)->Iterations(160);
