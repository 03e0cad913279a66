// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/excitation_run.h"

#include "backend/core/failure.h"
#include "backend/playback/measurement_end.h"

#include <QCoreApplication>

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace teleta::motors {

namespace {

struct RunText {
    Q_DECLARE_TR_FUNCTIONS(RunText)
};

constexpr std::int64_t kPeriod_ns = 1'000'000;
/// Time allowed for the player to start the program.
constexpr std::int64_t kLongestBegin_ns = 1'000'000'000;

} // namespace

playback::Program programOf(const Excitation& excitation, std::size_t tactor) {
    auto kept = std::make_shared<const Excitation>(excitation);
    const double duration_s = kept->duration_s;
    playback::Program program;
    program.evaluate = [kept = std::move(kept), tactor](double time_s) {
        core::Intensities drives{};
        drives[tactor] = kept->driveAt(time_s);
        return drives;
    };
    program.duration_s = duration_s;
    program.raw = true;
    return program;
}

core::Expected<MotorRecording> recordExcitation(playback::Player& player,
                                                const core::BraceletSource& bracelet, std::size_t tactor,
                                                const Excitation& excitation, const std::stop_token& stop,
                                                std::atomic<double>& progress, core::PacingClock& clock) {
    if (!bracelet.motorSpeeds())
        return core::failed(core::ErrorKind::unavailable,
                            RunText::tr("The bracelet does not measure its motors."),
                            RunText::tr("a recording with a sensor of your own, or answers of a person"));
    if (stop.stop_requested())
        return core::failed(core::ErrorKind::cancelled, RunText::tr("The measurement was ended."));
    std::mutex mutex;
    std::condition_variable never;
    std::unique_lock lock(mutex);
    const std::int64_t begin_ns = clock.now_ns();
    const std::uint64_t number = player.play(programOf(excitation, tactor));
    std::int64_t begun_ns = 0;
    MotorRecording recording;
    const auto samples = static_cast<std::size_t>(excitation.duration_s * 1e3) + 100;
    recording.time_s.reserve(samples);
    recording.drive.reserve(samples);
    recording.speed_Hz.reserve(samples);
    for (std::int64_t next_ns = begin_ns;; next_ns = std::max(next_ns + kPeriod_ns, clock.now_ns())) {
        while (clock.now_ns() < next_ns)
            clock.waitUntil(never, lock, next_ns);
        if (stop.stop_requested()) {
            player.stop(number);
            return core::failed(core::ErrorKind::cancelled, RunText::tr("The measurement was ended."));
        }
        const playback::PlayerStatus status = player.status();
        const bool isProgram = status.mode == playback::PlayerMode::program;
        if (begun_ns == 0) {
            if (isProgram && status.program == number) {
                begun_ns = status.begun_ns;
            } else if (clock.now_ns() - begin_ns > kLongestBegin_ns) {
                // A late player must not start after this function has given up.
                player.stop(number);
                return playback::measurementEnd(status);
            } else {
                continue;
            }
        }
        // Another program has replaced it.
        if (status.begun_ns != begun_ns)
            return playback::measurementEnd({});
        const auto reading = bracelet.motorSpeeds();
        if (reading && (recording.time_s.empty() || reading->time_ns > begin_ns)) {
            const double time_s = static_cast<double>(reading->time_ns - begin_ns) * 1e-9;
            if (recording.time_s.empty() || time_s > recording.time_s.back()) {
                recording.time_s.push_back(time_s);
                recording.drive.push_back(static_cast<double>(reading->drive[tactor]) / core::kFullDrive);
                recording.speed_Hz.push_back(reading->speeds_Hz[tactor]);
            }
        }
        progress = std::clamp(status.position_s / excitation.duration_s, 0.0, 1.0);
        if (isProgram)
            continue;
        if (status.ending == playback::PlayerEnding::finished)
            return recording;
        return playback::measurementEnd(status);
    }
}

} // namespace teleta::motors
