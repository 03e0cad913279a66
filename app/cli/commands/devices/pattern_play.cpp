// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/pattern_play.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/motors/motor_file.h"
#include "backend/motors/wearer_limits.h"
#include "backend/pattern/motors/overdriven.h"
#include "backend/playback/pattern_program.h"
#include "backend/playback/player.h"
#include "devices/bracelet/hid_bracelet.h"
#include "devices/described/described_bracelet.h"
#include "devices/simulated/simulated_bracelet.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <thread>
#include <utility>

namespace teleta::cli {

namespace {

struct PlayText {
    Q_DECLARE_TR_FUNCTIONS(PatternPlay)
};

using playback::PlayerEnding;

constexpr auto kLook = std::chrono::milliseconds(20);
constexpr std::int64_t kLongestConnect_ns = 3'000'000'000;

core::Expected<std::unique_ptr<core::BraceletSource>> openBracelet(const std::string& device,
                                                                   const core::StopSwitch& stop) {
    const auto asSource = [](std::unique_ptr<core::BraceletLink>&& link) {
        return std::unique_ptr<core::BraceletSource>(std::move(link));
    };
    if (device == "simulated")
        return std::make_unique<simulated::SimulatedBracelet>(stop);
    if (device == "usb")
        return bracelet::openHidBracelet({}, stop).map(asSource);
    return described::openBracelet(device, stop).map(asSource);
}

core::Expected<pattern::MotorProfiles> motorsOf(const std::string& path, const std::string& serial) {
    if (!path.empty()) {
        TELETA_TRY(const auto read, motors::readMotors(path));
        if (read.bracelet != serial)
            return core::Unexpected(core::Error{core::ErrorKind::badInput,
                                                PlayText::tr("the profile is of the bracelet \"%1\"")
                                                    .arg(QString::fromStdString(read.bracelet))
                                                    .toStdString(),
                                                serial,
                                                {path}});
        return read.profiles();
    }
    return motors::findMotors(serial).map([](const std::optional<motors::MotorCalibration>& found) {
        return found ? found->profiles() : pattern::assumedMotors();
    });
}

struct Quantiles {
    std::int64_t median_ns, p99_ns, longest_ns;
};

Quantiles quantilesOf(const playback::TimeHistogram& times) {
    return {times.quantile_ns(0.5), times.quantile_ns(0.99), times.longest_ns()};
}

/// Of one stretch of playing.
struct Measured {
    playback::PlayerCounters counters;
    playback::PlayerTimings timings;
};

Measured measuredBy(const playback::Player& player) {
    return {player.counters(), player.timings()};
}

const char* toString(core::ThreadUrgency urgency) {
    switch (urgency) {
    case core::ThreadUrgency::realTime:
        return "real_time";
    case core::ThreadUrgency::raised:
        return "raised";
    case core::ThreadUrgency::ordinary:
        return "ordinary";
    }
    return "";
}

nlohmann::ordered_json toJson(const Quantiles& quantiles) {
    return {{"median_s", static_cast<double>(quantiles.median_ns) * 1e-9},
            {"p99_s", static_cast<double>(quantiles.p99_ns) * 1e-9},
            {"longest_s", static_cast<double>(quantiles.longest_ns) * 1e-9}};
}

QString forPeopleUs(const Quantiles& quantiles) {
    const auto us = [](std::int64_t time_ns) { return forPeople(static_cast<double>(time_ns) * 1e-3, 3); };
    return PlayText::tr("median %1, 99 % below %2, longest %3 us")
        .arg(us(quantiles.median_ns), us(quantiles.p99_ns), us(quantiles.longest_ns));
}

core::Expected<void> endedWell(const playback::PlayerStatus& status) {
    switch (status.ending) {
    case PlayerEnding::deviceLost:
        return core::failed(core::ErrorKind::unavailable, PlayText::tr("The bracelet was lost."));
    case PlayerEnding::sourceFailed:
        return core::Unexpected(core::Error{core::ErrorKind::refused, status.message, {}, {}});
    case PlayerEnding::stalled:
        return core::failed(core::ErrorKind::refused,
                            PlayText::tr("A frame was so late that the bracelet had stopped."));
    case PlayerEnding::tooHot:
        return core::failed(core::ErrorKind::refused, PlayText::tr("The bracelet is too hot."),
                            PlayText::tr("let it cool down first"));
    default:
        return {};
    }
}

/// Waits until the playing has begun and ended. duration_s: ends it after so long.
void waitFor(playback::Player& player, std::optional<double> duration_s) {
    const std::int64_t begin_ns = core::steadyNow_ns();
    bool begun = false;
    for (;;) {
        std::this_thread::sleep_for(kLook);
        const playback::PlayerStatus status = player.status();
        begun = begun || status.mode != playback::PlayerMode::idle || status.ending != PlayerEnding::none;
        const double elapsed_s = static_cast<double>(core::steadyNow_ns() - begin_ns) * 1e-9;
        if ((begun && status.mode == playback::PlayerMode::idle) || interrupted() ||
            (duration_s && elapsed_s >= *duration_s))
            return;
    }
}

/// Posts what a live source would: a setpoint every now and then, at no fixed phase of the frames.
void postFor(playback::Player& player, double duration_s) {
    std::mt19937_64 random(1);
    std::uniform_int_distribution<int> pause_us(3'000, 25'000);
    const std::int64_t end_ns = core::steadyNow_ns() + static_cast<std::int64_t>(duration_s * 1e9);
    std::uint64_t k = 0;
    while (core::steadyNow_ns() < end_ns && !interrupted() && player.status().ending == PlayerEnding::none) {
        core::Intensities intensities{};
        intensities[k++ % core::kTactors] = 0.2;
        player.post(intensities, core::steadyNow_ns());
        std::this_thread::sleep_for(std::chrono::microseconds(pause_us(random)));
    }
}

nlohmann::ordered_json toJson(const core::SoundReport& sound, const core::BraceletDescription& bracelet) {
    const auto orNull = [](double value) {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
    };
    return {{"stated_latency_s", bracelet.statedLatency_s},
            {"measured_latency_s", orNull(bracelet.measuredLatency_s)},
            {"measured_latency_spread_s", orNull(bracelet.latencySpread_s)},
            {"callback_mean_share", sound.meanShare},
            {"callback_longest_share", sound.longestShare},
            {"missed_periods", sound.missedPeriods}};
}

/// What a sound card says of itself, whose coils nobody watches.
void addFields(const core::SoundReport& sound, const core::BraceletDescription& bracelet, Fields& fields) {
    fields.emplace_back(PlayText::tr("Confirmed"), PlayText::tr("played by the callback of the sound card"));
    fields.emplace_back(
        PlayText::tr("Latency"),
        std::isfinite(bracelet.measuredLatency_s)
            ? PlayText::tr("%1 ms, as measured").arg(forPeople(1e3 * bracelet.measuredLatency_s, 3))
            : PlayText::tr("at most %1 ms, as stated, not measured")
                  .arg(forPeople(1e3 * bracelet.statedLatency_s, 3)));
    fields.emplace_back(PlayText::tr("Callback"),
                        PlayText::tr("%1 % of a period, longest %2 %, %3 missed")
                            .arg(forPeople(1e2 * sound.meanShare, 2), forPeople(1e2 * sound.longestShare, 2))
                            .arg(sound.missedPeriods));
}

core::Expected<void> print(const core::BraceletSource& bracelet, const playback::Player& player,
                           const Measured& program, const std::optional<Measured>& live, bool json) {
    const Quantiles lateness = quantilesOf(program.timings.lateness);
    const Quantiles write = quantilesOf(program.timings.write);
    const Quantiles latency = live ? quantilesOf(live->timings.latency) : Quantiles{};
    const std::optional<core::SoundReport> sound = bracelet.telemetry().board.sound;
    if (json) {
        nlohmann::ordered_json document{{"bracelet", bracelet.description().name},
                                        {"simulated", bracelet.description().simulated},
                                        {"rate_hz", player.rate_Hz()},
                                        {"playback_thread", toString(player.urgency())},
                                        {"frames", program.counters.framesWritten},
                                        {"deadline_misses", program.counters.deadlineMisses},
                                        {"frames_lost", program.counters.framesLost},
                                        {"achieved_hz", program.counters.rate_Hz},
                                        {"lateness", toJson(lateness)},
                                        {"write", toJson(write)}};
        if (live)
            document["live"] = {{"setpoints", live->timings.latency.count()},
                                {"frames", live->counters.framesWritten},
                                {"deadline_misses", live->counters.deadlineMisses},
                                {"snapshot_to_frame", toJson(latency)}};
        if (sound)
            document["sound"] = toJson(*sound, bracelet.description());
        return printDocument(document);
    }
    Fields fields{
        {PlayText::tr("Bracelet"), QString::fromStdString(bracelet.description().name)},
        {PlayText::tr("Rate"), PlayText::tr("%1 Hz, achieved %2 Hz")
                                   .arg(forPeople(player.rate_Hz()), forPeople(program.counters.rate_Hz))},
        {PlayText::tr("Playback thread"), QLatin1String(toString(player.urgency()))},
        {PlayText::tr("Frames"), QString::number(program.counters.framesWritten)},
        {PlayText::tr("Deadlines missed"), QString::number(program.counters.deadlineMisses)},
        {PlayText::tr("Frames lost"), QString::number(program.counters.framesLost)},
        {PlayText::tr("Late by"), forPeopleUs(lateness)},
        {PlayText::tr("Write"), forPeopleUs(write)}};
    if (live) {
        fields.emplace_back(PlayText::tr("Setpoints"), QString::number(live->timings.latency.count()));
        fields.emplace_back(PlayText::tr("Misses meanwhile"), QString::number(live->counters.deadlineMisses));
        fields.emplace_back(PlayText::tr("Snapshot to frame"), forPeopleUs(latency));
    }
    if (sound)
        addFields(*sound, bracelet.description(), fields);
    return printFields(fields);
}

} // namespace

core::Expected<void> playPattern(const pattern::Pattern& drawn, const PlayOptions& options) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    TELETA_TRY(auto opened, openBracelet(options.device, stop));
    core::BraceletSource& bracelet = *opened;
    TELETA_TRY(const auto motors, motorsOf(options.motorsPath, bracelet.description().serial));
    TELETA_TRY(const auto limits, motors::findLimits(bracelet.description().serial));
    TELETA_TRY(const auto pattern, options.overdrive ? pattern::overdriven(drawn, motors) : drawn);
    bracelet.start(wakeup);
    const std::int64_t begin_ns = core::steadyNow_ns();
    while (bracelet.connection() == 0 && !interrupted() &&
           core::steadyNow_ns() - begin_ns < kLongestConnect_ns)
        wakeup.waitFor(kLook);
    if (bracelet.connection() == 0 && !interrupted()) {
        const core::DeviceStatus status = bracelet.status();
        return core::Unexpected(core::Error{
            core::ErrorKind::unavailable,
            status.message.empty() ? PlayText::tr("No bracelet answers.").toStdString() : status.message,
            {},
            {}});
    }

    playback::Player player(
        bracelet, stop, {.limits = {.userLimit = limits.strongest}, .ranges = playback::rangesOf(motors)});
    player.play(playback::programOf(pattern), options.measure_s.has_value());
    waitFor(player, options.measure_s);
    const Measured program = measuredBy(player);
    TELETA_CHECK(endedWell(player.status()));
    std::optional<Measured> live;
    if (options.measure_s && !interrupted()) {
        const std::int64_t before_ns = player.status().begun_ns;
        player.startLive();
        while (player.status().begun_ns == before_ns && !interrupted())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        postFor(player, *options.measure_s);
        live = measuredBy(player);
        TELETA_CHECK(endedWell(player.status()));
    }
    const bool cut = interrupted();
    // The motors are off before printing, which a slow reader of the output may delay.
    player.stop();
    return unlessCut(print(bracelet, player, program, live, options.json), cut);
}

} // namespace teleta::cli
