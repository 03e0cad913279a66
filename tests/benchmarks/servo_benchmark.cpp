// SPDX-License-Identifier: GPL-3.0-or-later
// The control cycle of the servo scenes at 1 kHz compared with real time, and the shares of its parts:
// contact, kinematics and inertia, features, control. With --sliding: a table of the highest sliding speeds
// along the bent bar without loss of contact, for each rate of the servo and each effect. Where MuJoCo is
// installed: its step of 1 ms of the same arm, held by the same spring in space, with the same pad of taxels
// on the same bar.
#include "backend/contact/tactile_features.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/servo/servo_measures.h"
#include "backend/servo/arm/lwr_arm.h"
#include "backend/simulation/servo/servo_loop.h"
#ifdef TELETA_MUJOCO
#include "tests/benchmarks/servo_in_mujoco.h"
#endif

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

/// The loop after its first seconds: in contact and in its final task.
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
    input.q_rad = servo::jointVector(loop->world().arm().state().q_rad);
    auto controller = servo::ServoController::create(
        loop->controller().plan(), std::make_shared<servo::LwrArm>(loop->world().arm().kinematics()));
    for (auto _ : state)
        benchmark::DoNotOptimize(controller->step(input));
}

/// The world alone: arm, contact and array, without features and control.
void worldPart(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    auto world = simulation::SimulatedServoWorld::make(shippedScene(name), 1);
    (*world)->setReference(loop->world().arm().X_Base_Reference());
    for (int i = 0; i < 2000; ++i)
        (*world)->next();
    std::int64_t cycles = 0;
    for (auto _ : state) {
        (*world)->next();
        ++cycles;
    }
    state.counters["force_N"] = (*world)->truth().force_N;
    state.counters["x_real_time"] =
        benchmark::Counter(static_cast<double>(cycles) / (*world)->rate_Hz(), benchmark::Counter::kIsRate);
}

#ifdef TELETA_MUJOCO
/// MuJoCo held to the reference that our arm has, after a second in which its own contact settles.
void mujoco(benchmark::State& state, const std::string& name) {
    const auto loop = runningLoop(name);
    const scene::Scene scene = shippedScene(name);
    const auto& robot = scene.servo().arm;
    simulation::Impedance impedance;
    impedance.stiffness_NPerM = robot.stiffness_NPerM;
    impedance.rotationalStiffness_NmPerRad = robot.rotationalStiffness_NmPerRad;
    impedance.dampingRatio = robot.dampingRatio;
    benchmarks::ServoInMujoco other(loop->world().arm(),
                                    std::get<scene::BarShape>(scene.servo().object.shape), impedance);
    for (int i = 0; i < 1000; ++i)
        other.step();
    std::int64_t cycles = 0;
    for (auto _ : state) {
        other.step();
        ++cycles;
    }
    state.counters["force_N"] = other.force_N();
    state.counters["taxels"] = other.pressedTaxels();
    state.counters["mass_difference_kgm2"] = other.massDifference_kgm2();
    state.counters["x_real_time"] =
        benchmark::Counter(1e-3 * static_cast<double>(cycles), benchmark::Counter::kIsRate);
}
#endif

constexpr double kWay_m = 0.1; ///< most of the bend of 0.12 m
constexpr double kLongest_s = 60.0;
constexpr double kMostForceError_N = 20.0;
constexpr double kFastest_mPerS = 0.2;
constexpr std::uint64_t kSlidingSeeds = 3;

/// Exploration at a fixed speed along the array's x regardless of the features: the law of the paper slides
/// by the place of the contact on the array, which slows it down long before the contact is lost.
bool pushOn(servo::ServoController& controller, double speed_mPerS) {
    const servo::ServoPlan plan = controller.plan();
    for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
        servo::ServoTask task = plan.tasks[i];
        if (task.kind != servo::TaskKind::explore)
            continue;
        task.projection.x = false;
        task.feedForward.constant_Sensor[servo::kX] = speed_mPerS;
        task.limits.toolSpeed_mPerS = 2.0 * kFastest_mPerS;
        return controller.setTask(i, task).has_value();
    }
    return false;
}

/// Whether the bend is passed at this speed without losing contact, a force 20 N too high, or a return to an
/// earlier task.
bool slides(const scene::Scene& scene, std::uint64_t seed, double speed_mPerS) {
    auto loop = simulation::ServoLoop::make(scene, seed);
    if (!loop || !pushOn((*loop)->controller(), speed_mPerS))
        return false;
    scene_run::ServoMeasures measures(scene);
    nlohmann::ordered_json reached;
    const auto cycles = static_cast<int>((kLongest_s + kWay_m / speed_mPerS) * scene.rate_Hz);
    const auto between = static_cast<int>(0.02 * scene.rate_Hz);
    for (int i = 1; i <= cycles; ++i) {
        (*loop)->next();
        measures.add(**loop);
        if (i % between != 0)
            continue;
        measures.report(reached);
        const auto& force_N = reached["force_max_error_n"];
        if (reached["contact_lost_s"].get<double>() > 0.0 || reached["phases"].size() > 4 ||
            (force_N.is_number() && force_N.get<double>() > kMostForceError_N))
            return false;
        if (reached["path_length_m"].get<double>() > kWay_m)
            return true;
    }
    return false;
}

bool allSlide(const scene::Scene& scene, double speed_mPerS) {
    for (std::uint64_t seed = 1; seed <= kSlidingSeeds; ++seed) {
        if (!slides(scene, seed, speed_mPerS))
            return false;
    }
    return true;
}

/// The highest speed at which no seed fails, to 5 %: steps of a quarter up to the first failure, then
/// bisection.
void printHighest(const std::string& what, const scene::Scene& scene) {
    constexpr double kSlowest_mPerS = 0.001;
    double good_mPerS = 0.0;
    double bad_mPerS = kSlowest_mPerS;
    while (bad_mPerS <= kFastest_mPerS && allSlide(scene, bad_mPerS)) {
        good_mPerS = bad_mPerS;
        bad_mPerS *= 1.25;
    }
    if (good_mPerS == 0.0) {
        std::printf("| %s | contact is lost at %.0f mm/s |\n", what.c_str(), 1e3 * kSlowest_mPerS);
        return;
    }
    const bool capped = bad_mPerS > kFastest_mPerS;
    while (!capped && bad_mPerS > 1.05 * good_mPerS) {
        const double middle_mPerS = 0.5 * (good_mPerS + bad_mPerS);
        (allSlide(scene, middle_mPerS) ? good_mPerS : bad_mPerS) = middle_mPerS;
    }
    std::printf("| %s | %s%.1f mm/s |\n", what.c_str(), capped ? "over " : "", 1e3 * good_mPerS);
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
    std::printf("| | slides without losing contact up to |\n|---|---|\n");
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
    with("drift of 30 mN in 20 s", scene::DriftSpec{.sd_N = 0.03, .timeConstant_s = 20.0});
    with("quantization of 0.1 N", scene::QuantizationSpec{.step_N = 0.1});
    with("friction of 0.3", scene::FrictionSpec{.coefficient = 0.3});
    with("latency of 20 ms", scene::LatencySpec{.delay_s = 0.02});
    with("latency of 100 ms", scene::LatencySpec{.delay_s = 0.1});
    with("a response bowed by 10 %", scene::NonlinearResponseSpec{.bow = 0.1});
    scene::DeadTaxelsSpec dead;
    dead.count = 4;
    with("4 dead taxels", dead);
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
        add("/world", worldPart);
#ifdef TELETA_MUJOCO
        if (scene == "servo-straight-bar")
            add("/mujoco", mujoco);
#endif
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
