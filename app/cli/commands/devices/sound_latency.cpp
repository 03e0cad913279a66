// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/sound_latency.h"

#include "app/cli/base/interruption.h"
#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/failure.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/playback/player.h"
#include "devices/sound_bracelet/click_listener.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>

namespace teleta::cli {

namespace {

struct LatencyText {
    Q_DECLARE_TR_FUNCTIONS(SoundLatency)
};

constexpr double kClickLength_s = 0.03;
constexpr double kQuiet_s = 0.2;     ///< before each click, in which the noise is measured
constexpr double kLongest_s = 0.5;   ///< until a click is heard
constexpr double kReconnect_s = 2.0; ///< after a missed period
constexpr int kDeaf = 5;             ///< clicks of which none was heard: nothing will be
constexpr float kTimesNoise = 4.0F;  ///< a click is louder than so much noise,
constexpr float kLeastLevel = 1e-4F; ///< and than this share of full scale
constexpr std::chrono::milliseconds kBetweenLooks{1};

/// Whether the condition came true in time.
template <typename Condition>
bool comes(double longest_s, const Condition& condition) {
    const std::int64_t end_ns = core::steadyNow_ns() + std::llround(longest_s * 1e9);
    while (!interrupted()) {
        if (condition())
            return true;
        if (core::steadyNow_ns() >= end_ns)
            return false;
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return false;
}

} // namespace

double SoundLatency::median_s() const {
    return core::medianOf(std::vector(clicks_s));
}

double SoundLatency::spread_s() const {
    const auto [shortest, longest] = std::ranges::minmax(clicks_s);
    return longest - shortest;
}

core::Expected<SoundLatency> measureSoundLatency(const sound::SoundBraceletFile& file,
                                                 core::BraceletSource& bracelet, const core::StopSwitch& stop,
                                                 const std::string& port) {
    TELETA_TRY(const auto listener, sound::ClickListener::open(file, port));
    playback::Player player(bracelet, stop);
    SoundLatency latency;
    float noise = 0.0F;
    const auto goesOn = [&](int attempt) {
        const auto heard = std::ssize(latency.clicks_s);
        return attempt < (heard > 0 ? 2 * kClicks : kDeaf) && heard < kClicks;
    };
    for (int attempt = 0; goesOn(attempt); ++attempt) {
        const auto isIdle = [&] { return player.status().mode == playback::PlayerMode::idle; };
        if (!comes(kReconnect_s, [&] { return bracelet.connection() != 0 && isIdle(); }))
            continue;
        // Clicks at all places of a period: the pauses are no multiples of it.
        (void)comes(kQuiet_s, [] { return false; });
        (void)listener->takePeak();
        (void)comes(kQuiet_s + 1e-3 * std::fmod(3.7 * attempt, 20.0), [] { return false; });
        noise = listener->takePeak();
        listener->arm(std::max(kTimesNoise * noise, kLeastLevel));
        const std::int64_t request_ns = core::steadyNow_ns();
        player.play({[](double) { return core::Intensities{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }, kClickLength_s});
        const bool heard = comes(kLongest_s, [&] { return listener->heard_ns() != 0; });
        const std::int64_t onset_ns = player.status().begun_ns >= request_ns ? player.counters().onset_ns : 0;
        (void)comes(kLongest_s, isIdle);
        // What was heard before the frame was written is noise.
        if (heard && onset_ns != 0 && listener->heard_ns() >= onset_ns)
            latency.clicks_s.push_back(1e-9 * static_cast<double>(listener->heard_ns() - onset_ns));
    }
    player.stop();
    if (interrupted())
        return core::Unexpected(interruption());
    if (std::ssize(latency.clicks_s) < kClicks)
        return core::failed(
            core::ErrorKind::unavailable,
            LatencyText::tr("only %1 of %2 clicks were heard on %3, whose noise reaches %4 of full scale")
                .arg(latency.clicks_s.size())
                .arg(kClicks)
                .arg(QString::fromStdString(port))
                .arg(static_cast<double>(noise), 0, 'g', 2),
            LatencyText::tr("an accelerometer at tactor 1, or a cable from its output to this input"));
    return latency;
}

} // namespace teleta::cli
