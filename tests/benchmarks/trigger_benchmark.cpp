// SPDX-License-Identifier: GPL-3.0-or-later
// Time from posting a trigger until its write has returned, by a pseudo-terminal and by UDP, each from the
// sender's thread and, for comparison in the same run, written by the posting thread itself.
#include "backend/study/session/trigger_sender.h"
#include "devices/trigger/osc_trigger.h"
#include "devices/trigger/serial_trigger.h"
#include "tests/support/pseudo_terminal.h"
#include "tests/support/udp_listener.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace {

using namespace teleta;

constexpr int kEvents = 2000;
constexpr double kAllowed_ms = 2.0;
/// About as far apart as they are in a session would take too long; far enough for the thread to sleep.
constexpr std::chrono::milliseconds kApart{2};

core::TriggerEvent stimulus() {
    core::TriggerEvent event;
    event.kind = core::TriggerEvent::Kind::stimulus;
    event.index = 1;
    event.session = "20261103T142233";
    event.trial = 1;
    return event;
}

void report(benchmark::State& state, std::vector<double> times_ms) {
    std::sort(times_ms.begin(), times_ms.end());
    const auto at = [&](double share) {
        return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
    };
    state.counters["p50_ms"] = at(0.5);
    state.counters["p99_ms"] = at(0.99);
    state.counters["max_ms"] = at(1.0);
    const auto late =
        static_cast<double>(times_ms.end() - std::upper_bound(times_ms.begin(), times_ms.end(), kAllowed_ms));
    state.counters["under_2ms_%"] = 100.0 * (1.0 - late / static_cast<double>(times_ms.size()));
}

/// The onset is now: onsetToWritten_ms() then is the time that the sender takes.
void bySender(benchmark::State& state, const study::TriggerSender::Opener& opener, const auto& receive) {
    std::vector<double> times_ms;
    for (auto _ : state) {
        study::TriggerSender sender(opener);
        for (int i = 0; i < kEvents; ++i) {
            std::this_thread::sleep_for(kApart);
            const std::int64_t now_ns = core::steadyNow_ns();
            sender.await(stimulus(), [now_ns] { return now_ns; });
            receive();
            while (!sender.onsetToWritten_ms())
                std::this_thread::yield();
            times_ms.push_back(*sender.onsetToWritten_ms());
        }
    }
    report(state, std::move(times_ms));
}

void byCaller(benchmark::State& state, const study::TriggerSender::Opener& opener, const auto& receive) {
    std::vector<double> times_ms;
    for (auto _ : state) {
        const auto port = opener().value();
        for (int i = 0; i < kEvents; ++i) {
            std::this_thread::sleep_for(kApart);
            const std::int64_t now_ns = core::steadyNow_ns();
            (void)port->write(stimulus());
            times_ms.push_back(1e-6 * static_cast<double>(core::steadyNow_ns() - now_ns));
            receive();
        }
    }
    report(state, std::move(times_ms));
}

void serialBySender(benchmark::State& state) {
    const test::PseudoTerminal line;
    bySender(
        state, [&] { return trigger::SerialTrigger::open(line.name(), 0.0); }, [&] { (void)line.read(1); });
}

void serialByCaller(benchmark::State& state) {
    const test::PseudoTerminal line;
    byCaller(
        state, [&] { return trigger::SerialTrigger::open(line.name(), 0.0); }, [&] { (void)line.read(1); });
}

void oscBySender(benchmark::State& state) {
    const test::UdpListener listener;
    bySender(
        state, [&] { return trigger::OscTrigger::open("127.0.0.1", listener.port()); },
        [&] { (void)listener.read(); });
}

void oscByCaller(benchmark::State& state) {
    const test::UdpListener listener;
    byCaller(
        state, [&] { return trigger::OscTrigger::open("127.0.0.1", listener.port()); },
        [&] { (void)listener.read(); });
}

BENCHMARK(serialBySender)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(serialByCaller)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(oscBySender)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(oscByCaller)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
