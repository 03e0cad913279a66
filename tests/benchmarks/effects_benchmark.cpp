// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of the shipped scenes with a tactile array: without any effect, with those that the scene lists,
// and with each kind alone, against the same motion, contact, threshold and rounding written out here without
// the machinery of effects. A ratio of 1 for the scene without effects means that an effect that is not
// listed costs nothing.
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace teleta;

/// One loop of the scene with the ball and the bar.
constexpr int kFrames = 4000;

scene::Scene indenterScene(std::vector<scene::Effect> effects) {
    core::Expected<scene::Scene> scene =
        scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/tactile-indenter.toml");
    if (!scene)
        throw std::runtime_error(core::describe(scene.error()));
    scene->effects = std::move(effects);
    return *scene;
}

/// What SimulatedArray does when there is no effect at all.
class BareArray {
public:
    explicit BareArray(const scene::Scene& scene)
        : m_rate_Hz(scene.rate_Hz)
        , m_threshold_N(scene.array().sensor.firingThreshold_N)
        , m_contact(scene.array().sensor.layout, scene.array().sensor.stiffness_NPerM)
        , m_load_N(scene.array().sensor.layout.taxels())
        , m_loads(scene.array().indenters.size()) {
        for (const scene::Indenter& indenter : scene.array().indenters) {
            m_motions.emplace_back(indenter.keyframes, indenter.loop);
            m_indenters.emplace_back(indenter.shape);
        }
    }

    void next(std::span<float> values) {
        const double time_s = static_cast<double>(++m_frame) / m_rate_Hz;
        for (std::size_t i = 0; i < m_indenters.size(); ++i)
            m_indenters[i].moveTo(m_motions[i].at(time_s));
        m_contact.press(m_indenters, m_load_N, m_loads);
        for (double& load_N : m_load_N)
            load_N = load_N < m_threshold_N ? 0.0 : load_N;
        std::ranges::transform(m_load_N, values.begin(),
                               [](double load_N) { return static_cast<float>(load_N); });
    }

private:
    double m_rate_Hz;
    double m_threshold_N;
    simulation::FoundationContact m_contact;
    std::vector<simulation::KeyframeMotion> m_motions;
    std::vector<simulation::RigidIndenter> m_indenters;
    std::vector<double> m_load_N;
    std::vector<simulation::IndenterLoad> m_loads;
    int m_frame = 0;
};

void registerRun(const std::string& name, const std::function<void(std::span<float>)>& next) {
    benchmark::RegisterBenchmark(name.c_str(), [next](benchmark::State& state) {
        std::vector<float> values(6 * 14);
        for (auto _ : state)
            for (int i = 0; i < kFrames; ++i) {
                next(values);
                benchmark::DoNotOptimize(values.data());
            }
    })->Unit(benchmark::kMicrosecond);
}

void registerScene(const std::string& name, std::vector<scene::Effect> effects) {
    auto made = simulation::SimulatedArray::make(indenterScene(std::move(effects)), 1);
    if (!made)
        throw std::runtime_error(core::describe(made.error()));
    registerRun(name, [array = std::shared_ptr(std::move(*made))](std::span<float> values) {
        array->next(values, false);
    });
}

/// Keeps the processor time of every repetition and prints only the table.
class KeepingReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& reports) override {
        for (const Run& run : reports)
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                auto& times_us = m_frame_us[run.run_name.function_name];
                if (times_us.empty())
                    m_order.push_back(run.run_name.function_name);
                times_us.push_back(run.GetAdjustedCPUTime() / kFrames);
            }
    }

    void printTable(const std::string& against) {
        std::printf("%-28s %10s %8s %16s\n", "frame of 6 x 14", "median us", "ratio", "quartiles");
        std::ranges::sort(m_order, {}, [this](const std::string& run) { return quantile_us(run, 0.5); });
        for (const std::string& run : m_order) {
            const double bare_us = quantile_us(against, 0.5);
            std::printf("%-28s %10.3f %8.3f %8.3f %7.3f\n", run.c_str(), quantile_us(run, 0.5),
                        quantile_us(run, 0.5) / bare_us, quantile_us(run, 0.25) / bare_us,
                        quantile_us(run, 0.75) / bare_us);
        }
    }

private:
    [[nodiscard]] double quantile_us(const std::string& run, double share) {
        auto& times_us = m_frame_us[run];
        if (times_us.empty())
            return std::numeric_limits<double>::quiet_NaN();
        std::ranges::sort(times_us);
        return times_us[static_cast<std::size_t>(share * static_cast<double>(times_us.size() - 1) + 0.5)];
    }

    std::vector<std::string> m_order;
    std::map<std::string, std::vector<double>> m_frame_us;
};

constexpr char kBare[] = "written out, no effects";

void registerRuns() {
    registerRun(kBare, [array = std::make_shared<BareArray>(indenterScene({}))](std::span<float> values) {
        array->next(values);
    });
    registerScene("scene, no effects", {});
    registerScene("scene as it is shipped",
                  scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/tactile-indenter.toml")->effects);
    const std::vector<scene::Effect> kinds{
        {"", scene::CrosstalkSpec{.share = 0.12}},
        {"", scene::HysteresisSpec{.share = 0.15}},
        {"", scene::DriftSpec{.sd_N = 0.05, .timeConstant_s = 60.0}},
        {"", scene::NoiseSpec{.sd_N = 0.015}},
        {"", scene::QuantizationSpec{.step_N = 0.0007}},
        {"", scene::SaturationSpec{}},
        {"", scene::DeadTaxelsSpec{
                 .taxels = {}, .count = 2, .reading_N = std::numeric_limits<double>::quiet_NaN()}}};
    for (const scene::Effect& kind : kinds)
        registerScene("scene, only " + std::string(nameOf(kind)), {kind});
}

} // namespace

int main(int argc, char** argv) {
    // Many short repetitions, mixed over all runs, so that a disturbance of the machine affects all alike.
    std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=31", "--benchmark_min_time=0.01",
                                       "--benchmark_enable_random_interleaving=true"};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data()))
        return 2;
    try {
        registerRuns();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "effects_benchmark: %s\n", error.what());
        return 1;
    }
    KeepingReporter results;
    benchmark::RunSpecifiedBenchmarks(&results);
    results.printTable(kBare);
    return 0;
}
