// SPDX-License-Identifier: GPL-3.0-or-later
// The control cycle of the servo scenes at 1 kHz against real time, and the shares of its parts: contact,
// kinematics and inertia, features, control. With --sliding: a table of the highest sliding speeds along the
// bent bar without loss of contact, for each rate of the servo and each effect: the command, which the
// position of the contact on the array holds back, and the speed that it leads to.
#include "backend/contact/tactile_features.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/servo_measures.h"
#include "backend/simulation/servo/servo_loop.h"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
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

constexpr double kWay_m = 0.1; ///< the bend is 0.12 m long, and the array begins in its middle
constexpr double kLongest_s = 120.0;
constexpr double kMostForceError_N = 20.0;
constexpr std::uint64_t kSlidingSeeds = 3;

/// Mean speed over the bend; nothing when contact is lost for a moment, the force is 20 N too high, or the
/// array does not arrive.
std::optional<double> slide(const scene::Scene& scene, std::uint64_t seed) {
    auto loop = simulation::ServoLoop::make(scene, seed);
    if (!loop)
        return std::nullopt;
    scene_run::ServoMeasures measures(scene);
    nlohmann::ordered_json reached;
    std::optional<double> start_s;
    const auto cycles = static_cast<int>(kLongest_s * scene.rate_Hz);
    const auto between = static_cast<int>(0.1 * scene.rate_Hz);
    for (int i = 1; i <= cycles; ++i) {
        (*loop)->next();
        measures.add(**loop);
        if (i % between != 0)
            continue;
        measures.report(reached);
        if (!start_s && reached["path_length_m"].get<double>() > 0.0)
            start_s = (*loop)->world().time_s();
        const auto& force_N = reached["force_max_error_n"];
        if (reached["contact_lost_s"].get<double>() > 0.0 ||
            (force_N.is_number() && force_N.get<double>() > kMostForceError_N))
            return std::nullopt;
        if (start_s && reached["path_length_m"].get<double>() > kWay_m)
            return kWay_m / ((*loop)->world().time_s() - *start_s);
    }
    return std::nullopt;
}

/// Commands higher and higher speeds until one of the seeds fails.
void printHighest(const std::string& what, scene::Scene scene) {
    constexpr std::array kSpeeds_mPerS{0.0025, 0.005, 0.01, 0.02, 0.03, 0.04, 0.05};
    double commanded_mPerS = 0.0;
    double slowest_mPerS = 0.0;
    for (const double speed_mPerS : kSpeeds_mPerS) {
        scene.servo().task.slide_mPerS = speed_mPerS;
        double reached_mPerS = std::numeric_limits<double>::infinity();
        for (std::uint64_t seed = 1; seed <= kSlidingSeeds && reached_mPerS > 0.0; ++seed)
            reached_mPerS = std::min(reached_mPerS, slide(scene, seed).value_or(0.0));
        if (!(reached_mPerS > 0.0))
            break;
        commanded_mPerS = speed_mPerS;
        slowest_mPerS = reached_mPerS;
    }
    std::printf("| %s | %.1f mm/s | %.1f mm/s |\n", what.c_str(), 1e3 * commanded_mPerS, 1e3 * slowest_mPerS);
    std::fflush(stdout);
}

void printSlidingTable() {
    scene::Scene full = shippedScene("servo-bent-bar");
    full.effects = shippedScene("servo-bent-bar-baseline").effects;
    full.effects.push_back({"", scene::NoiseSpec{.sd_N = 0.015}});
    scene::Scene plain = full;
    std::erase_if(plain.effects, [](const scene::Effect& effect) {
        return !std::holds_alternative<scene::ContactDampingSpec>(effect.parameters);
    });
    std::printf("| | highest command | slides at |\n|---|---|---|\n");
    for (const double rate_Hz : {5.0, 10.0, 25.0, 50.0, 100.0, 200.0}) {
        scene::Scene scene = full;
        scene.servo().sensor.servo_Hz = rate_Hz;
        printHighest("servo at " + std::to_string(static_cast<int>(rate_Hz)) + " Hz", scene);
    }
    printHighest("100 Hz, damping only", plain);
    const auto with = [&](const char* name, auto spec) {
        scene::Scene scene = plain;
        scene.effects.push_back({"", spec});
        printHighest(std::string("and ") + name, scene);
    };
    with("noise of 15 mN", scene::NoiseSpec{.sd_N = 0.015});
    with("noise of 30 mN", scene::NoiseSpec{.sd_N = 0.03});
    with("noise of 60 mN", scene::NoiseSpec{.sd_N = 0.06});
    with("the housing", scene::HousingRimSpec{});
    with("crosstalk of 12 %", scene::CrosstalkSpec{.share = 0.12});
    with("hysteresis of 15 %", scene::HysteresisSpec{.share = 0.15});
    with("borders stiffer by half", scene::BorderStiffeningSpec{.share = 0.5});
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
