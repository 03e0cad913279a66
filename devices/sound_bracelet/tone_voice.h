// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace teleta::sound {

/// Frequencies of the five levels of vibration, with which the carrier follows the intensity.
using LevelFrequencies = std::array<double, 5>;

/// How one tactor sounds. Whoever makes one keeps the ranges.
struct ToneSettings {
    double carrier_Hz = 250.0; ///< 20 .. 1000
    /// Instead of the carrier: its frequencies at the intensities 1/2, 5/8, 3/4, 7/8 and 1 of the levels,
    /// linear between them. Below, the line of the first two goes on, but not under 20 Hz.
    std::optional<LevelFrequencies> level_Hz{};
    double fullScale = 0.5; ///< sample at drive 1, > 0, at most 0.9
    double gain = 1.0;      ///< 0 .. 1
    double ramp_s = 0.002;  ///< from one setpoint to the next

    bool operator==(const ToneSettings&) const = default;

    /// Frequency at this intensity, 0 .. 1.
    [[nodiscard]] double frequency_Hz(double intensity) const;
    /// The highest one.
    [[nodiscard]] double highest_Hz() const;
    /// Shortest ramp with which no sample steps further than those of the steady tone at full scale do:
    ///   sqrt(2) / (4 f),   f the highest frequency
    [[nodiscard]] double shortestRamp_s() const;
};

/// The signal of one tactor: a sine whose amplitude follows the drive along raised cosines,
///   x = fullScale gain d(t) sin(phase),   d(t) = d0 + (d1 - d0) (1 - cos(pi t / ramp)) / 2
/// The phase runs on through setpoints and starts at 0 from rest. Samples are finite and never exceed
/// fullScale. Nothing is allocated. Thread: one.
class ToneVoice {
public:
    /// rate_Hz: of the samples.
    ToneVoice(const ToneSettings& settings, double rate_Hz);

    /// Goes to this drive, 0 .. 1, from the next sample on. NaN is 0, other values are clamped. ramp_s: at
    /// most that of the settings.
    void aim(double drive, double ramp_s);
    /// The next samples.
    void render(std::span<float> samples);
    /// Off at once; the next tone starts at phase 0.
    void silence();

    [[nodiscard]] bool isSilent() const { return m_drive == 0.0 && m_to == 0.0; }

private:
    [[nodiscard]] double nextDrive();

    ToneSettings m_settings;
    double m_rate_Hz;
    double m_amplitude;
    double m_phase_rad = 0.0;
    double m_drive = 0.0; ///< of the last sample
    double m_from = 0.0;  ///< of the ramp
    double m_to = 0.0;
    std::size_t m_rampFrames = 0;
    std::size_t m_rampFrame = 0; ///< == m_rampFrames: the ramp is over
};

} // namespace teleta::sound
