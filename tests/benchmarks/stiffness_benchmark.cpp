// SPDX-License-Identifier: GPL-3.0-or-later
// Object stiffness of a simulated touch of rubber (7223.9 N/m, 0.5 mNm of torque noise) with a number of
// samples in the window: the paper's two points, the regression, and total least squares by Eigen's SVD over
// the window with the noise ratio given. error_mean: mean relative error of k_o over the touches, with the
// time of the same run.
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <benchmark/benchmark.h>
#include <Eigen/SVD>

#include <cmath>
#include <vector>

namespace {

using namespace teleta::stiffness;
using teleta::stiffness::test::SimulatedTouch;

constexpr double kObject_NPerM = 7223.9;
constexpr std::size_t kTouches = 64;

SimulatedTouch worldOf(std::int64_t samplesInWindow) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / kObject_NPerM;
    world.angleNoise_rad = 1e-7;
    const double joint_NmPerRad =
        world.contactDistance_m * world.contactDistance_m * world.totalStiffness_NPerM();
    world.speed_radPerS = 0.03 / joint_NmPerRad * world.rate_Hz / static_cast<double>(samplesInWindow);
    world.freeMotion_s = 0.02;
    return world;
}

std::vector<std::vector<JointSample>> touchesOf(const SimulatedTouch& world) {
    std::vector<std::vector<JointSample>> touches;
    for (std::size_t seed = 0; seed < kTouches; ++seed)
        touches.push_back(world.record(seed));
    return touches;
}

/// k_o by total least squares: the smallest right singular vector of the centred, whitened samples is the
/// line's normal.
double bySvd_NPerM(const std::vector<JointSample>& log, const SimulatedTouch& world) {
    Eigen::MatrixX2d points(log.size(), 2);
    Eigen::Index count = 0;
    for (const JointSample& sample : log)
        if (sample.torque_Nm >= 0.02 && sample.torque_Nm <= 0.05)
            points.row(count++) << sample.torque_Nm / world.torqueNoise_Nm,
                sample.angle_rad / world.angleNoise_rad;
    points.conservativeResize(count, Eigen::NoChange);
    points.rowwise() -= points.colwise().mean().eval();
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(points, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd normal = svd.matrixV().col(1);
    const double slope_radPerNm = -normal[0] / normal[1] * world.angleNoise_rad / world.torqueNoise_Nm;
    return 1.0 /
           (world.contactDistance_m * world.contactDistance_m * slope_radPerNm - 1.0 / world.link_NPerM);
}

template <typename Estimate>
void measure(benchmark::State& state, const Estimate& estimate) {
    const SimulatedTouch world = worldOf(state.range(0));
    const auto touches = touchesOf(world);
    double error = 0.0;
    for (const auto& touch : touches)
        error += std::abs(estimate(touch, world) - kObject_NPerM) / kObject_NPerM / kTouches;
    std::size_t next = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(estimate(touches[next], world));
        next = (next + 1) % kTouches;
    }
    state.counters["error_mean"] = error;
}

double byEstimator_NPerM(Method method, const std::vector<JointSample>& log, const SimulatedTouch& world) {
    TouchSettings settings;
    settings.contactDistance_m = world.contactDistance_m;
    settings.linkStiffness_NPerM = world.link_NPerM;
    settings.method = method;
    const auto touch = estimateStiffness(log, settings);
    if (!touch)
        return 0.0;
    return touch->object.value_NPerM.value_or(*touch->object.lower95_NPerM);
}

void stiffnessTwoPoint(benchmark::State& state) {
    measure(state, [](const auto& log, const SimulatedTouch& world) {
        return byEstimator_NPerM(Method::twoPoint, log, world);
    });
}

void stiffnessRegression(benchmark::State& state) {
    measure(state, [](const auto& log, const SimulatedTouch& world) {
        return byEstimator_NPerM(Method::regression, log, world);
    });
}

void stiffnessEigenSvd(benchmark::State& state) {
    measure(state, [](const auto& log, const SimulatedTouch& world) { return bySvd_NPerM(log, world); });
}

/// As an arm delivers a touch: a second of free motion at 1 kHz before it.
SimulatedTouch worldOfAnArm(std::int64_t samplesInWindow) {
    SimulatedTouch world = worldOf(samplesInWindow);
    world.freeMotion_s = 1.0;
    return world;
}

template <typename Estimate>
void measureOfAnArm(benchmark::State& state, const Estimate& estimate) {
    const SimulatedTouch world = worldOfAnArm(state.range(0));
    const auto touches = touchesOf(world);
    TouchSettings settings;
    settings.contactDistance_m = world.contactDistance_m;
    settings.linkStiffness_NPerM = world.link_NPerM;
    settings.patternsAreErrors = true;
    std::size_t next = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(estimate(touches[next], settings));
        next = (next + 1) % kTouches;
    }
}

void touchOfAnArm(benchmark::State& state) {
    measureOfAnArm(state, [](const auto& log, const TouchSettings& settings) {
        return estimateStiffness(log, settings).has_value();
    });
}

void complianceOfAnArm(benchmark::State& state) {
    measureOfAnArm(state, [](const auto& log, const TouchSettings& settings) {
        return estimateObjectCompliance(log, settings).has_value();
    });
}

BENCHMARK(touchOfAnArm)->Arg(100)->Arg(1000);
BENCHMARK(complianceOfAnArm)->Arg(100)->Arg(1000);
BENCHMARK(stiffnessTwoPoint)->Arg(10)->Arg(50)->Arg(100)->Arg(1000);
BENCHMARK(stiffnessRegression)->Arg(10)->Arg(50)->Arg(100)->Arg(1000);
BENCHMARK(stiffnessEigenSvd)->Arg(10)->Arg(50)->Arg(100)->Arg(1000);

} // namespace
