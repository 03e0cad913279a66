// SPDX-License-Identifier: GPL-3.0-or-later
// evaluate() of a pattern with 200 breakpoints, which must take less than a microsecond, plain and compiled,
// compared with a linear search through the same breakpoints.
#include "backend/pattern/model/pattern.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using teleta::core::Intensities;
using namespace teleta::pattern;

constexpr double kDuration_s = 10.0;

/// 34 breakpoints on four tracks, 32 on two: 200. One in five segments has each easing.
Pattern pattern200() {
    Pattern pattern;
    pattern.duration_s = kDuration_s;
    for (std::size_t i = 0; i < pattern.tracks.size(); ++i) {
        const int points = i < 4 ? 34 : 32;
        for (int k = 0; k < points; ++k)
            pattern.tracks[i].push_back(
                {kDuration_s * k / (points - 1), 0.5 + 0.5 * std::sin(1.7 * k), static_cast<Easing>(k % 5)});
    }
    return pattern;
}

/// Times spread over the pattern in an order that a cache cannot learn.
double timeOf(unsigned call) {
    return kDuration_s * std::fmod(0.618033988749895 * call, 1.0);
}

void evaluateOf200Breakpoints(benchmark::State& state) {
    const Pattern pattern = pattern200();
    unsigned call = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(pattern, timeOf(call++)));
}
BENCHMARK(evaluateOf200Breakpoints);

void compiledOf200Breakpoints(benchmark::State& state) {
    const CompiledPattern pattern(pattern200());
    unsigned call = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(pattern.evaluate(timeOf(call++)));
}
BENCHMARK(compiledOf200Breakpoints);

void compiledWith20Objects(benchmark::State& state) {
    Pattern pattern = pattern200();
    for (int k = 0; k < 20; ++k)
        pattern.objects.push_back({"", Ring{0.5 * k, 0.5, 1, k % 6, true, std::nullopt, 1.0}, {}});
    const CompiledPattern compiled(pattern);
    unsigned call = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(compiled.evaluate(timeOf(call++)));
}
BENCHMARK(compiledWith20Objects);

void linearSearchOf200Breakpoints(benchmark::State& state) {
    const Pattern pattern = pattern200();
    unsigned call = 0;
    for (auto _ : state) {
        const double t_s = timeOf(call++);
        Intensities intensities{};
        for (std::size_t i = 0; i < intensities.size(); ++i) {
            const Track& track = pattern.tracks[i];
            for (std::size_t k = 1; k < track.size(); ++k) {
                const Breakpoint& a = track[k - 1];
                const Breakpoint& b = track[k];
                if (t_s >= a.time_s && t_s < b.time_s)
                    intensities[i] =
                        a.intensity + (t_s - a.time_s) / (b.time_s - a.time_s) * (b.intensity - a.intensity);
            }
        }
        benchmark::DoNotOptimize(intensities);
    }
}
BENCHMARK(linearSearchOf200Breakpoints);

} // namespace
