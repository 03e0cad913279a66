// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/tone_engine.h"

#include "backend/core/steady_time.h"

#include <algorithm>

namespace teleta::sound {

namespace {

/// For a counter that one thread writes.
template <typename T>
void add(std::atomic<T>& counter, T value) {
    counter.store(counter.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
}

std::array<ToneVoice, core::kTactors> voicesOf(const ToneEngine::Tones& tones, double rate_Hz) {
    return {ToneVoice(tones[0], rate_Hz), ToneVoice(tones[1], rate_Hz), ToneVoice(tones[2], rate_Hz),
            ToneVoice(tones[3], rate_Hz), ToneVoice(tones[4], rate_Hz), ToneVoice(tones[5], rate_Hz)};
}

} // namespace

ToneEngine::ToneEngine(const Tones& tones, double rate_Hz, const core::StopSwitch& stopSwitch)
    : m_rate_Hz(rate_Hz)
    , m_stopSwitch(stopSwitch)
    , m_voices(voicesOf(tones, rate_Hz))
    , m_engagements(stopSwitch.engagements()) {
}

void ToneEngine::set(const SoundSetpoint& setpoint) {
    m_setpoints.back() = setpoint;
    m_setpoints.publish();
}

bool ToneEngine::played(PlayedFrame& frame) {
    return m_played.pop(frame);
}

void ToneEngine::render(const Outputs& outputs, std::int64_t now_ns) {
    m_called_ns.store(now_ns, std::memory_order_release);
    m_frames.store(outputs.front().size(), std::memory_order_release);
    if (fault() != SoundFault::none)
        return silence(outputs);
    aim(now_ns);
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_voices[i].render(outputs[i]);
    m_audible.store(!std::ranges::all_of(m_voices, &ToneVoice::isSilent), std::memory_order_release);
    const std::int64_t busy_ns = core::steadyNow_ns() - now_ns;
    add<std::uint64_t>(m_callbacks, 1);
    add(m_busy_ns, busy_ns);
    m_longest_ns.store(std::max(m_longest_ns.load(std::memory_order_relaxed), busy_ns),
                       std::memory_order_relaxed);
}

void ToneEngine::aim(std::int64_t now_ns) {
    const std::uint64_t engagements = m_stopSwitch.engagements();
    const bool stopped = m_stopSwitch.engaged() || engagements != m_engagements;
    m_engagements = engagements;
    const bool fresh = m_setpoints.update();
    const SoundSetpoint& setpoint = m_setpoints.front();
    const bool timedOut = !core::isOff(setpoint.drive) && now_ns - setpoint.written_ns > setpoint.timeout_ns;
    if (stopped)
        m_held = true;
    else if (fresh)
        m_held = false;
    const bool off = m_held || timedOut;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_voices[i].aim(off ? 0.0 : static_cast<double>(setpoint.drive[i]) / core::kFullDrive,
                        off ? kStopRamp_s : 1.0);
    m_timedOut = m_timedOut || timedOut;
    if (!fresh)
        return;
    m_played.push({.played_ns = now_ns,
                   .sequence = setpoint.sequence,
                   .driving = !off && !core::isOff(setpoint.drive),
                   .timedOut = m_timedOut});
    m_timedOut = timedOut;
}

void ToneEngine::silence(const Outputs& outputs) {
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        m_voices[i].silence();
        std::ranges::fill(outputs[i], 0.0F);
    }
    m_audible.store(false, std::memory_order_release);
}

void ToneEngine::missPeriod() {
    m_missedPeriods.fetch_add(1, std::memory_order_relaxed);
    if (isAudible())
        fail(SoundFault::missedPeriod);
}

void ToneEngine::fail(SoundFault fault) {
    SoundFault none = SoundFault::none;
    m_fault.compare_exchange_strong(none, fault, std::memory_order_acq_rel);
}

CallbackCost ToneEngine::cost() const {
    CallbackCost cost;
    cost.callbacks = m_callbacks.load(std::memory_order_relaxed);
    cost.missedPeriods = m_missedPeriods.load(std::memory_order_relaxed);
    const auto period_ns = static_cast<double>(frames()) / m_rate_Hz * 1e9;
    if (cost.callbacks > 0 && period_ns > 0.0) {
        cost.meanShare = static_cast<double>(m_busy_ns.load(std::memory_order_relaxed)) /
                         static_cast<double>(cost.callbacks) / period_ns;
        cost.longestShare = static_cast<double>(m_longest_ns.load(std::memory_order_relaxed)) / period_ns;
    }
    return cost;
}

} // namespace teleta::sound
