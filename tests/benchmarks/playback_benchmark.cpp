// SPDX-License-Identifier: GPL-3.0-or-later
// The steps between a setpoint and the bracelet.
//   clampOnly       six values clamped and rounded to integers, nothing else: the reference for the limiter
//   limiter         clamp, user's limit, slew limit, heat budget, integer
//   encodeFrame     the HID report
//   liveCycle       a whole cycle of the playback thread: mailbox, limiter, frame, counters, status
//   handOver        two threads and a condition variable: the reference for the next one
//   setpointToFrame post() on this thread until the simulated bracelet has the frame, median and 99 %
//   play10s         10 s at 200 Hz on the simulated bracelet: deadlines missed, write times
#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/steady_time.h"
#include "backend/playback/player.h"
#include "devices/bracelet/bracelet_reports.h"
#include "devices/simulated/simulated_bracelet.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>
#include <vector>

namespace {

using namespace teleta;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Different setpoints, so that nothing can be precomputed.
std::vector<core::Intensities> setpoints() {
    std::vector<core::Intensities> made(1024);
    for (std::size_t k = 0; k < made.size(); ++k)
        for (std::size_t i = 0; i < core::kTactors; ++i)
            made[k][i] = static_cast<double>((k * 37 + i * 101) % 1200) / 1000.0 - 0.1;
    return made;
}

void clampOnly(benchmark::State& state) {
    const auto wanted = setpoints();
    std::size_t k = 0;
    for (auto _ : state) {
        const core::Intensities& intensities = wanted[k++ % wanted.size()];
        core::Drive drive;
        for (std::size_t i = 0; i < core::kTactors; ++i)
            drive[i] = static_cast<std::uint16_t>(std::clamp(intensities[i], 0.0, 1.0) * core::kFullDrive);
        benchmark::DoNotOptimize(drive);
    }
}

void limiter(benchmark::State& state) {
    const auto wanted = setpoints();
    playback::SafetyLimiter limiter({}, 0.005);
    std::size_t k = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(limiter.step(wanted[k++ % wanted.size()], 0.005));
}

void encodeFrame(benchmark::State& state) {
    core::Drive drive{1, 2, 3, 4, 5, 6};
    std::uint16_t sequence = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(drive);
        benchmark::DoNotOptimize(bracelet::encodeFrame(++sequence, drive, 100));
    }
}

class NoBracelet : public core::BraceletSource {
public:
    [[nodiscard]] const core::BraceletDescription& description() const override { return m_description; }
    void start(core::Wakeup&) override {}
    void stop() override {}
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }
    [[nodiscard]] core::BraceletTelemetry telemetry() const override { return {}; }
    [[nodiscard]] std::uint64_t connection() const override { return 1; }
    core::WriteResult write(const core::BraceletFrame& frame) override {
        benchmark::DoNotOptimize(frame);
        return {core::WriteOutcome::written, core::steadyNow_ns()};
    }

private:
    core::BraceletDescription m_description{.maximumRate_Hz = 1e9};
};

void liveCycle(benchmark::State& state) {
    NoBracelet bracelet;
    core::StopSwitch stop;
    // Fast enough that every call has a frame to write.
    playback::PlaybackCycle cycle(bracelet, stop, {.rate_Hz = 1e8});
    playback::PlayerCommands begin;
    begin.start = playback::LiveRequest{};
    benchmark::DoNotOptimize(cycle.run(std::move(begin)));
    const auto wanted = setpoints();
    std::size_t k = 0;
    for (auto _ : state) {
        cycle.setpoints().post({wanted[k++ % wanted.size()], core::steadyNow_ns()});
        benchmark::DoNotOptimize(cycle.run({}));
    }
    state.counters["frames"] = static_cast<double>(cycle.counters().framesWritten);
}

void report(benchmark::State& state, std::vector<double>& times_us) {
    std::sort(times_us.begin(), times_us.end());
    state.counters["median_us"] = times_us[times_us.size() / 2];
    state.counters["p99_us"] = times_us[times_us.size() * 99 / 100];
}

void handOver(benchmark::State& state) {
    core::Wakeup wakeup;
    std::atomic<std::int64_t> arrived_ns{0};
    std::jthread other([&](const std::stop_token& stop) {
        while (!stop.stop_requested())
            if (wakeup.waitFor(std::chrono::milliseconds(10)))
                arrived_ns = core::steadyNow_ns();
    });
    std::vector<double> times_us;
    for (auto _ : state) {
        state.PauseTiming();
        std::this_thread::sleep_for(std::chrono::milliseconds(7));
        arrived_ns = 0;
        state.ResumeTiming();
        const std::int64_t posted_ns = core::steadyNow_ns();
        wakeup.notify();
        while (arrived_ns == 0)
            std::this_thread::yield();
        times_us.push_back(static_cast<double>(arrived_ns - posted_ns) / 1000.0);
    }
    report(state, times_us);
}

void setpointToFrame(benchmark::State& state) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    simulated::SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    while (bracelet.connection() == 0)
        wakeup.waitFor(std::chrono::milliseconds(10));
    playback::Player player(bracelet, stop, {.limits = {.rise_perS = kInfinity, .heatBudget = 1.0}});
    player.startLive();
    std::vector<double> times_us;
    std::uint16_t drive = 0;
    for (auto _ : state) {
        state.PauseTiming();
        std::this_thread::sleep_for(std::chrono::milliseconds(7));
        drive = static_cast<std::uint16_t>(drive % 4000 + 1);
        core::Intensities wanted;
        wanted.fill(static_cast<double>(drive) / core::kFullDrive);
        state.ResumeTiming();
        const std::int64_t posted_ns = core::steadyNow_ns();
        player.post(wanted, posted_ns);
        while (bracelet.drive()[0] != drive)
            std::this_thread::yield();
        times_us.push_back(static_cast<double>(core::steadyNow_ns() - posted_ns) / 1000.0);
    }
    report(state, times_us);
}

void play10s(benchmark::State& state) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    simulated::SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    while (bracelet.connection() == 0)
        wakeup.waitFor(std::chrono::milliseconds(10));
    for (auto _ : state) {
        playback::Player player(bracelet, stop);
        player.play({[](double t_s) { return core::Intensities{t_s / 10.0}; }, 10.0});
        while (player.status().ending == playback::PlayerEnding::none)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const playback::PlayerCounters counters = player.counters();
        state.counters["frames"] = static_cast<double>(counters.framesWritten);
        state.counters["missed"] = static_cast<double>(counters.deadlineMisses);
        state.counters["lost"] = static_cast<double>(counters.framesLost);
        state.counters["writeMedian_us"] = static_cast<double>(counters.writeMedian_ns) / 1000.0;
        state.counters["writeLongest_us"] = static_cast<double>(counters.writeLongest_ns) / 1000.0;
    }
}

BENCHMARK(clampOnly);
BENCHMARK(limiter);
BENCHMARK(encodeFrame);
BENCHMARK(liveCycle);
BENCHMARK(handOver)->Iterations(300)->UseRealTime();
BENCHMARK(setpointToFrame)->Iterations(300)->UseRealTime();
BENCHMARK(play10s)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

} // namespace
