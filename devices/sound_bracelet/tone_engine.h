// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/threads/bounded_queue.h"
#include "backend/core/threads/latest_exchange.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/sound_bracelet/tone_voice.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::sound {

/// Why the card is no longer driven. It stays silent until it is opened again.
enum class SoundFault {
    none,
    missedPeriod,     ///< samples came too late while a tactor was driven
    serverGone,       ///< the server ended, or closed the connection
    deviceGone,       ///< the card was unplugged, suspended or taken away
    rateChanged,      ///< another sample rate
    periodChanged,    ///< another number of samples at a time
    disconnected,     ///< a tactor is no longer connected to its output
    sharedWithOthers, ///< another program plays on the card
    callbacksStopped, ///< nobody asks for samples any more
};

/// A frame of the bracelet on its way to the callback.
struct SoundSetpoint {
    core::Drive drive{};
    std::int64_t written_ns = 0; ///< steady time
    std::int64_t timeout_ns = 0; ///< without a newer one for so long the tactors go to 0
    std::uint16_t sequence = 0;
};

/// A setpoint that the callback took.
struct PlayedFrame {
    std::int64_t played_ns = 0; ///< steady time at which the callback of its first sample began
    std::uint16_t sequence = 0;
    bool driving = false;  ///< a tactor is driven by it
    bool timedOut = false; ///< the tactors had been turned off, because no setpoint came
};

/// What the callbacks cost since the opening.
struct CallbackCost {
    std::uint64_t callbacks = 0;
    std::uint64_t missedPeriods = 0;
    double meanShare = 0.0;    ///< of the period
    double longestShare = 0.0; ///< of the period, with the time in which other programs had the core
};

/// What the callback of a sound card does, whatever the API: setpoints in, samples of six tactors out.
/// Safety, each by itself:
///   - STOP is looked at in every callback; pressed, or pressed and released since the last one, the tactors
///     go to 0, and only a setpoint after it drives them again;
///   - without a setpoint for its timeout they go to 0;
///   - both within kStopRamp_s, or faster if the ramp is;
///   - after a fault all samples are 0 at once, for good.
/// Thread: set() and played() one at a time; render() from the callback: it neither allocates nor locks;
/// the rest by any.
class ToneEngine {
public:
    static constexpr double kStopRamp_s = 0.005;
    using Tones = std::array<ToneSettings, core::kTactors>;
    using Outputs = std::array<std::span<float>, core::kTactors>;

    /// stopSwitch must outlive it.
    ToneEngine(const Tones& tones, double rate_Hz, const core::StopSwitch& stopSwitch);

    void set(const SoundSetpoint& setpoint);
    /// The next setpoint that was taken; false: none since the last call.
    [[nodiscard]] bool played(PlayedFrame& frame);

    /// Fills the outputs, all equally long. now_ns: steady time at which the callback began.
    void render(const Outputs& outputs, std::int64_t now_ns);

    /// The card lost a period: a fault if a tactor is driven, else only counted.
    void missPeriod();
    void fail(SoundFault fault);

    [[nodiscard]] SoundFault fault() const { return m_fault.load(std::memory_order_acquire); }
    /// Whether the newest callback moved a tactor.
    [[nodiscard]] bool isAudible() const { return m_audible.load(std::memory_order_acquire); }
    /// Steady time of the newest callback; 0: there was none.
    [[nodiscard]] std::int64_t called_ns() const { return m_called_ns.load(std::memory_order_acquire); }
    /// Samples of the newest callback.
    [[nodiscard]] std::size_t frames() const { return m_frames.load(std::memory_order_acquire); }
    [[nodiscard]] CallbackCost cost() const;

private:
    void aim(std::int64_t now_ns);
    void silence(const Outputs& outputs);

    double m_rate_Hz;
    const core::StopSwitch& m_stopSwitch;
    core::LatestExchange<SoundSetpoint> m_setpoints;
    core::BoundedQueue<PlayedFrame> m_played{256};

    // The callback's own.
    std::array<ToneVoice, core::kTactors> m_voices;
    std::uint64_t m_engagements;
    bool m_held = true;      ///< off until a setpoint comes
    bool m_timedOut = false; ///< since the last setpoint

    std::atomic<SoundFault> m_fault{SoundFault::none};
    std::atomic<bool> m_audible{false};
    std::atomic<std::int64_t> m_called_ns{0};
    std::atomic<std::size_t> m_frames{0};
    std::atomic<std::uint64_t> m_missedPeriods{0};
    // Written by the callback alone.
    std::atomic<std::uint64_t> m_callbacks{0};
    std::atomic<std::int64_t> m_busy_ns{0};
    std::atomic<std::int64_t> m_longest_ns{0};
};

} // namespace teleta::sound
