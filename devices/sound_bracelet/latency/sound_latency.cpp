// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/latency/sound_latency.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/playback/measurement_end.h"
#include "devices/sound_bracelet/latency/click_listener.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <thread>

namespace teleta::sound {

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

/// On tactor 1, as the device drives it.
playback::Program click() {
    return {.evaluate = [](double) { return core::Intensities{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}; },
            .duration_s = kClickLength_s,
            .raw = true};
}

/// Plays the clicks of one measurement.
class Clicking {
public:
    Clicking(const core::BraceletSource& bracelet, playback::Player& player, ClickListener& listener,
             const LatencyWatch& watch)
        : m_bracelet(bracelet)
        , m_player(player)
        , m_listener(listener)
        , m_watch(watch) {}

    /// The latency of a click; nothing: it was not heard, or not played.
    std::optional<double> next(int attempt) {
        if (!comes(kReconnect_s, [&] { return m_bracelet.connection() != 0 && isIdle(); }))
            return std::nullopt;
        // Clicks at all places of a period: the pauses are no multiples of it.
        (void)comes(kQuiet_s, [] { return false; });
        (void)m_listener.takePeak();
        (void)comes(kQuiet_s + 1e-3 * std::fmod(3.7 * attempt, 20.0), [] { return false; });
        if (!m_watch.goesOn())
            return std::nullopt;
        m_noise = m_listener.takePeak();
        m_listener.arm(std::max(kTimesNoise * m_noise, kLeastLevel));
        m_number = m_player.play(click());
        const bool heard = comes(kLongest_s, [&] { return m_listener.heard_ns() != 0; });
        const bool isOurs = m_player.status().program == m_number;
        const std::int64_t onset_ns = isOurs ? m_player.counters().onset_ns : 0;
        (void)comes(kLongest_s, [&] { return isIdle(); });
        // What was heard before the frame was written is noise.
        if (!heard || onset_ns == 0 || m_listener.heard_ns() < onset_ns)
            return std::nullopt;
        return 1e-9 * static_cast<double>(m_listener.heard_ns() - onset_ns);
    }

    /// Why no further click can be played.
    [[nodiscard]] core::Expected<void> check() const {
        if (!m_watch.goesOn())
            return core::failed(core::ErrorKind::cancelled, LatencyText::tr("The measurement was ended."));
        const playback::PlayerStatus status = m_player.status();
        if (m_number == 0)
            return {};
        if (status.settled > m_number)
            return playback::measurementEnd({});
        if (status.ending == playback::PlayerEnding::stopSwitch ||
            status.ending == playback::PlayerEnding::tooHot)
            return playback::measurementEnd(status);
        return {};
    }
    [[nodiscard]] float noise() const { return m_noise; }
    /// Ends the click that plays, and nothing else.
    void stop() { m_player.stop(m_number); }

private:
    [[nodiscard]] bool isIdle() const { return m_player.status().mode == playback::PlayerMode::idle; }
    /// Whether the condition came true in time.
    template <typename Condition>
    bool comes(double longest_s, const Condition& condition) {
        const std::int64_t end_ns = core::steadyNow_ns() + std::llround(longest_s * 1e9);
        while (m_watch.goesOn()) {
            if (condition())
                return true;
            if (core::steadyNow_ns() >= end_ns)
                return false;
            std::this_thread::sleep_for(kBetweenLooks);
        }
        return false;
    }

    const core::BraceletSource& m_bracelet;
    playback::Player& m_player;
    ClickListener& m_listener;
    const LatencyWatch& m_watch;
    std::uint64_t m_number = 0; ///< of the newest click
    float m_noise = 0.0F;
};

} // namespace

double SoundLatency::median_s() const {
    return core::medianOf(std::vector(clicks_s));
}

double SoundLatency::spread_s() const {
    const auto [shortest, longest] = std::ranges::minmax(clicks_s);
    return longest - shortest;
}

core::Expected<SoundLatency> measureSoundLatency(const SoundBraceletFile& file,
                                                 const core::BraceletSource& bracelet,
                                                 playback::Player& player, const std::string& input,
                                                 const LatencyWatch& watch) {
    TELETA_TRY(const auto listener, ClickListener::open(file, input));
    Clicking clicking(bracelet, player, *listener, watch);
    SoundLatency latency;
    const auto goesOn = [&](int attempt) {
        const auto heard = std::ssize(latency.clicks_s);
        return attempt < (heard > 0 ? 2 * kClicks : kDeaf) && heard < kClicks;
    };
    for (int attempt = 0; goesOn(attempt); ++attempt) {
        const auto click_s = clicking.next(attempt);
        if (const auto free = clicking.check(); !free) {
            clicking.stop();
            return core::Unexpected(free.error());
        }
        if (!click_s)
            continue;
        latency.clicks_s.push_back(*click_s);
        if (watch.heard)
            watch.heard(*click_s);
    }
    if (std::ssize(latency.clicks_s) < kClicks)
        return core::failed(
            core::ErrorKind::unavailable,
            LatencyText::tr("only %1 of %2 clicks were heard on %3, whose noise reaches %4 of full scale")
                .arg(latency.clicks_s.size())
                .arg(kClicks)
                .arg(QString::fromStdString(input))
                .arg(static_cast<double>(clicking.noise()), 0, 'g', 2),
            LatencyText::tr("an accelerometer at tactor 1, or a cable from its output to this input"));
    return latency;
}

} // namespace teleta::sound
