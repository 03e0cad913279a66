// SPDX-License-Identifier: GPL-3.0-or-later
// The control cycle of the servo scenes at 1 kHz against real time, and the shares of its parts: contact,
// kinematics and inertia, features, control. With --sliding: a table of the highest sliding speeds along the
// bent bar without loss of contact, for each rate of the servo and each effect.
#include "backend/contact/tactile_features.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/scene_run.h"
#include "backend/simulation/servo/servo_loop.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace {

using namespace teleta;

scene::Scene shippedScene(const std::string& name) {
    auto scene = scene::readScene(TELETA_SOURCE_DIR "/resources/scenes/" + name + ".toml");
    if (!scene) {
        std::fprintf(stderr, "servo_benchmark: %s\n", describe(scene.error()).c_str());
        std::exit(1);
    }
    return *scene;
}

/// The loop after its first seconds: in contact, in its lasting task.
std::unique_ptr<simulation::ServoLoop> runningLoop(const std::string& name) {
    auto loop = simulation::ServoLoop::make(shippedScene(name), 1);
    for (int i = 0; i < 6000; ++i)
        (*loop)->next();
    return std::move(*loop);
}

void cycle(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    std::int64_t cycles = 0;
    for (auto _ : state) {
        loop->next();
        if (++cycles % 20000 == 0) {
            state.PauseTiming();
            loop->restart();
            for (int i = 0; i < 6000; ++i)
                loop->next();
            state.ResumeTiming();
        }
    }
    state.counters["x_real_time"] = benchmark::Counter(static_cast<double>(cycles) / loop->world().rate_Hz(),
                                                       benchmark::Counter::kIsRate);
}

void contactPart(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    const simulation::ImpedanceArm& arm = loop->world().arm();
    const Eigen::Isometry3d X_Sensor_Object = arm.X_Base_Sensor().inverse() * arm.X_Base_Object();
    for (auto _ : state)
        benchmark::DoNotOptimize(arm.array().press(X_Sensor_Object, arm.object().shape));
}

void kinematicsPart(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    const simulation::ImpedanceArm& arm = loop->world().arm();
    for (auto _ : state)
        benchmark::DoNotOptimize(arm.kinematics().forward(arm.state().q_rad));
}

void featuresPart(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    const scene::Scene scene = shippedScene(name);
    contact::FeatureExtractor extractor(scene.taxels(), simulation::servoFeatures(scene));
    for (auto _ : state)
        benchmark::DoNotOptimize(extractor.compute(loop->frame()));
}

void controlPart(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    servo::ServoInput input;
    input.features = loop->features();
    input.dt_s = 0.01;
    input.X_Base_Sensor = loop->world().arm().X_Base_Sensor();
    input.q_rad = loop->world().arm().state().q_rad;
    auto controller = servo::ServoController::create(loop->controller().plan(),
                                                     servo::ArmGuard{loop->world().arm().kinematics(), {}});
    for (auto _ : state)
        benchmark::DoNotOptimize(controller->step(input));
}

/// True when the array slides over the whole bend without a moment off the bar and without 20 N too much.
bool slides(scene::Scene scene, double speed_mPerS, double* reached_mPerS) {
    scene.servo().task.slide_mPerS = speed_mPerS;
    scene_run::RunOptions options;
    options.duration_s = 3.0 + 0.1 / (0.4 * speed_mPerS);
    const auto summary = scene_run::runScene(scene, options);
    if (!summary || !summary->measures["force_max_error_n"].is_number())
        return false;
    *reached_mPerS = summary->measures["path_length_m"].get<double>() / (*options.duration_s - 3.0);
    return summary->measures["contact_lost_s"].get<double>() == 0.0 &&
           summary->measures["force_max_error_n"].get<double>() < 20.0;
}

void printHighest(const char* what, const scene::Scene& scene) {
    constexpr std::array kSpeeds_mPerS{0.0025, 0.005, 0.0075, 0.01, 0.0125, 0.015,
                                       0.02,   0.025, 0.03,   0.04, 0.05};
    double highest_mPerS = 0.0;
    double way_mPerS = 0.0;
    for (const double speed_mPerS : kSpeeds_mPerS) {
        double reached_mPerS = 0.0;
        if (!slides(scene, speed_mPerS, &reached_mPerS))
            break;
        highest_mPerS = speed_mPerS;
        way_mPerS = reached_mPerS;
    }
    std::printf("%-40s %6.1f mm/s commanded, %5.1f mm/s on the way\n", what, 1e3 * highest_mPerS,
                1e3 * way_mPerS);
    std::fflush(stdout);
}

void printSlidingTable() {
    scene::Scene plain = shippedScene("servo-bent-bar");
    const scene::Scene full = plain;
    std::erase_if(plain.effects, [](const scene::Effect& effect) {
        return !std::holds_alternative<scene::ContactDampingSpec>(effect.parameters);
    });
    for (const double rate_Hz : {10.0, 25.0, 50.0, 100.0, 200.0}) {
        scene::Scene scene = full;
        scene.servo().sensor.servo_Hz = rate_Hz;
        printHighest(("servo at " + std::to_string(static_cast<int>(rate_Hz)) + " Hz").c_str(), scene);
    }
    printHighest("no effect but damping", plain);
    const auto with = [&](const char* name, auto spec) {
        scene::Scene scene = plain;
        scene.effects.push_back({"", spec});
        printHighest(name, scene);
    };
    with("noise", scene::NoiseSpec{.sd_N = 0.015});
    with("four times the noise", scene::NoiseSpec{.sd_N = 0.06});
    with("housing_rim", scene::HousingRimSpec{});
    with("crosstalk", scene::CrosstalkSpec{.share = 0.12});
    with("hysteresis", scene::HysteresisSpec{.share = 0.15});
    with("border_stiffening", scene::BorderStiffeningSpec{.share = 0.5});
    with("saturation", scene::SaturationSpec{});
}

} // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--sliding") {
            printSlidingTable();
            return 0;
        }
    }
    for (const char* name : {"servo-straight-bar", "servo-bent-bar", "servo-bent-bar-baseline",
                             "servo-comanipulation", "servo-roll", "servo-point"}) {
        const std::string scene = name;
        const auto add = [&](const char* part, auto function) {
            benchmark::RegisterBenchmark((scene + part).c_str(), [function, scene](benchmark::State& state) {
                function(state, scene);
            });
        };
        add("/cycle", cycle);
        add("/contact", contactPart);
        add("/kinematics", kinematicsPart);
        add("/features", featuresPart);
        add("/control", controlPart);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
