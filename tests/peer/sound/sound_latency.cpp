// SPDX-License-Identifier: GPL-3.0-or-later
// Measures from a setpoint to the first sample that a second client gets back from a sink of PipeWire, and
// counts missed periods meanwhile. Runs in with_sound_session.sh.
//   sound_latency [PERIOD [CHANGES [SECONDS]]]
// The last line, over SECONDS with a pattern that changes all the time: cost of the callback and missed
// periods.
#include "backend/core/steady_time.h"
#include "backend/playback/player.h"
#include "devices/sound_bracelet/sound_bracelet.h"
#include "tests/peer/sound/monitor_recorder.h"
#include "tests/peer/sound/sound_server.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

using namespace teleta;

namespace {

void printTimes(const char* what, std::vector<double> times_ms, double period_ms) {
    std::ranges::sort(times_ms);
    const auto at = [&](double share) {
        return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
    };
    std::printf(
        "%s: %zu changes, median %.2f ms (%.2f periods), 99 %% %.2f ms (%.2f periods), longest %.2f ms\n",
        what, times_ms.size(), at(0.5), at(0.5) / period_ms, at(0.99), at(0.99) / period_ms, times_ms.back());
}

} // namespace

int main(int count, char** arguments) {
    const auto number = [&](int i, int otherwise) { return count > i ? std::atoi(arguments[i]) : otherwise; };
    const auto period_frames = static_cast<std::uint32_t>(number(1, 128));
    const int changes = number(2, 300);
    const int seconds = number(3, 60);
    peer::SoundServer server;
    auto file = sound::parseSoundBracelet("kind = 'sound_bracelet'\nname = 'x'\ndevice = 'pipewire:tactors'\n"
                                          "channels = [1, 2, 3, 4, 5, 6]\nperiod_frames = " +
                                              std::to_string(period_frames) + '\n',
                                          "coils.toml");
    core::StopSwitch stop;
    if (!server.start() || !file) {
        std::fprintf(stderr, "no sound server\n");
        return 1;
    }
    auto bracelet = sound::openSoundBracelet(*file, stop);
    if (!bracelet) {
        std::fprintf(stderr, "%s\n", core::describe(bracelet.error()).c_str());
        return 1;
    }
    core::Wakeup wakeup;
    (*bracelet)->start(wakeup);
    std::array<std::string, 6> monitors;
    for (std::size_t i = 0; i < monitors.size(); ++i)
        monitors[i] = "tactors:monitor_AUX" + std::to_string(i);
    peer::MonitorRecorder recorder(0);
    if (!recorder.start(sound::pipeWireLibraries().front(), monitors, period_frames)) {
        std::fprintf(stderr, "no recorder\n");
        return 1;
    }
    const double period_ms = 1e3 * file->period_s();
    std::mt19937 random(1);
    std::uniform_int_distribution<int> pauses_us(0, 20'000);
    const auto lost = [](const char* what) {
        std::printf("%s: a change did not come back\n", what);
        return 1;
    };

    const auto silence = [&] {
        for (int i = 0; i < 1000 && recorder.silentFor() < 2 * period_frames; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::this_thread::sleep_for(std::chrono::microseconds(pauses_us(random)));
    };
    const auto heard_ms = [&](std::int64_t from_ns) {
        for (int i = 0; i < 1000 && recorder.heard_ns() == 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return recorder.heard_ns() == 0 ? -1.0 : static_cast<double>(recorder.heard_ns() - from_ns) * 1e-6;
    };
    std::vector<double> times_ms;
    for (int i = 0; i < changes; ++i) {
        silence();
        recorder.arm();
        const std::int64_t begin_ns = core::steadyNow_ns();
        (void)(*bracelet)->write({{4095, 0, 0, 0, 0, 0}, 100, (*bracelet)->connection()});
        times_ms.push_back(heard_ms(begin_ns));
        if (times_ms.back() < 0.0)
            return lost("setpoint to sample");
        (void)(*bracelet)->write({{}, 100, (*bracelet)->connection()});
    }
    printTimes("frame to first sample", times_ms, period_ms);

    playback::Player player(**bracelet, stop);
    player.startLive();
    times_ms.clear();
    for (int i = 0; i < changes; ++i) {
        player.post({}, core::steadyNow_ns());
        silence();
        recorder.arm();
        const std::int64_t begin_ns = core::steadyNow_ns();
        player.post({1, 0, 0, 0, 0, 0}, begin_ns);
        times_ms.push_back(heard_ms(begin_ns));
        if (times_ms.back() < 0.0)
            return lost("touch to sample");
    }
    printTimes("setpoint of the live loop to first sample", times_ms, period_ms);

    player.play({[](double t_s) {
                     const double wave = 0.35 + 0.3 * std::sin(20.0 * t_s);
                     return core::Intensities{wave, wave, wave, wave, wave, wave};
                 },
                 static_cast<double>(seconds)});
    std::this_thread::sleep_for(std::chrono::seconds(seconds));
    const auto report = (*bracelet)->telemetry().board.sound;
    if (report)
        std::printf("callback over %d s: mean %.2f %% of a period, longest %.1f %%; missed periods %llu\n",
                    seconds, 1e2 * report->meanShare, 1e2 * report->longestShare,
                    static_cast<unsigned long long>(report->missedPeriods));
    const playback::PlayerCounters counters = player.counters();
    std::printf("frames %llu, lost %llu, deadlines missed %llu\n",
                static_cast<unsigned long long>(counters.framesWritten),
                static_cast<unsigned long long>(counters.framesLost),
                static_cast<unsigned long long>(counters.deadlineMisses));
    player.stop();
    return 0;
}
