// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time of a frame of the 3-D view outside OpenGL: arrays changed in place, against all of the sensor made
// anew.
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene/touch_scene.h"

#include <benchmark/benchmark.h>

using namespace teleta;

namespace {

core::ArrayLayout layoutOf(const benchmark::State& state) {
    return {.rows = static_cast<int>(state.range(0)),
            .columns = static_cast<int>(state.range(1)),
            .pitchX_m = 0.0034};
}

/// Two frames that alternate, so that every iteration has new loads and contacts.
std::vector<pipeline::TouchSnapshot> framesOf(const core::ArrayLayout& layout) {
    return {test::pressed(layout, {{1, -0.01, 0.0, 1.0}, {2, 0.012, 0.001, 0.7}}, 1),
            test::pressed(layout, {{1, -0.008, 0.001, 1.1}, {2, 0.011, 0.0, 0.6}}, 2)};
}

void inPlace(benchmark::State& state) {
    auto frames = framesOf(layoutOf(state));
    view3d::TouchScene scene(view3d::SceneColours(base::designedPalette(true)));
    std::uint64_t frame = 0;
    for (auto _ : state) {
        auto& next = frames[frame % 2];
        next.frame = next.framesProcessed = ++frame;
        scene.take(next);
        scene.draw();
    }
}

void madeAnew(benchmark::State& state) {
    auto frames = framesOf(layoutOf(state));
    const view3d::SceneColours colours(base::designedPalette(true));
    view3d::TouchScene scene(colours);
    std::uint64_t frame = 0;
    for (auto _ : state) {
        auto& next = frames[frame % 2];
        next.frame = next.framesProcessed = ++frame;
        scene.take(next);
        scene.applyColours(colours); // marks the body stale
        scene.draw();
    }
}

BENCHMARK(inPlace)->Args({6, 14})->Args({27, 64})->Args({256, 256})->Unit(benchmark::kMicrosecond);
BENCHMARK(madeAnew)->Args({6, 14})->Args({27, 64})->Args({256, 256})->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
