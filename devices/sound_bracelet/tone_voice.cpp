// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/tone_voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::sound {

namespace {

using std::numbers::pi;

constexpr double kLowest_Hz = 20.0;
constexpr double kFirstLevel = 0.5;
constexpr double kLevelStep = 0.125;

/// NaN is 0.
double share(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

} // namespace

double ToneSettings::frequency_Hz(double intensity) const {
    if (!level_Hz)
        return carrier_Hz;
    const LevelFrequencies& levels = *level_Hz;
    const double place = (intensity - kFirstLevel) / kLevelStep;
    const double whole = std::clamp(std::floor(place), 0.0, static_cast<double>(levels.size() - 2));
    const auto i = static_cast<std::size_t>(whole);
    return std::max(levels[i] + (place - whole) * (levels[i + 1] - levels[i]), kLowest_Hz);
}

double ToneSettings::highest_Hz() const {
    return level_Hz ? *std::ranges::max_element(*level_Hz) : carrier_Hz;
}

double ToneSettings::shortestRamp_s() const {
    return std::numbers::sqrt2 / (4.0 * highest_Hz());
}

ToneVoice::ToneVoice(const ToneSettings& settings, double rate_Hz)
    : m_settings(settings)
    , m_rate_Hz(rate_Hz)
    , m_amplitude(settings.fullScale * share(settings.gain)) {
}

void ToneVoice::aim(double drive, double ramp_s) {
    const double to = share(drive);
    const auto frames =
        static_cast<std::size_t>(std::lround(std::min(ramp_s, m_settings.ramp_s) * m_rate_Hz));
    // A ramp that is under way goes on, unless it has to end sooner.
    if (to == m_to && m_rampFrames - m_rampFrame <= frames)
        return;
    if (isSilent())
        m_phase_rad = 0.0;
    m_from = m_drive;
    m_to = to;
    m_rampFrames = frames;
    m_rampFrame = 0;
}

double ToneVoice::nextDrive() {
    if (m_rampFrame >= m_rampFrames)
        return m_to;
    const double passed = static_cast<double>(m_rampFrame++) / static_cast<double>(m_rampFrames);
    return m_from + (m_to - m_from) * 0.5 * (1.0 - std::cos(pi * passed));
}

void ToneVoice::render(std::span<float> samples) {
    if (isSilent()) {
        std::ranges::fill(samples, 0.0F);
        return;
    }
    const auto limit = static_cast<float>(m_settings.fullScale);
    for (float& sample : samples) {
        m_drive = nextDrive();
        const auto value = static_cast<float>(m_amplitude * m_drive * std::sin(m_phase_rad));
        // Behind everything else.
        sample = std::isnan(value) ? 0.0F : std::clamp(value, -limit, limit);
        m_phase_rad += 2.0 * pi * m_settings.frequency_Hz(m_drive) / m_rate_Hz;
        if (m_phase_rad >= 2.0 * pi)
            m_phase_rad -= 2.0 * pi;
    }
}

void ToneVoice::silence() {
    m_drive = m_from = m_to = 0.0;
    m_rampFrames = m_rampFrame = 0;
}

} // namespace teleta::sound
