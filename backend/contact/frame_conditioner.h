// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

/// How raw taxel values are converted to loads.
struct ConditioningSettings {
    /// Raw value of each taxel without load, of vectors three each; empty: zero. NaN marks a dead taxel.
    std::vector<float> tare;
    double gain = 1.0;     ///< N (or the unit shown) per raw unit; finite, not zero
    bool inverted = false; ///< the raw value decreases under load
    /// Factor on each taxel's load that makes all taxels read the same under the same load
    /// (findTaxelGains()); empty: 1. NaN marks a dead taxel.
    std::vector<float> taxelGain = {};
    std::vector<std::uint8_t> dead; ///< 1: the taxel is never used; empty: all are used
};

/// Converts a raw frame to loads.
///   load = max(0, s gain taxelGain (raw - tare)), s = -1 when inverted, else 1
/// A taxel that is marked dead, or whose raw value, tare, gain or load is not finite, is dead in this frame:
/// load 0, mask 1. Negative loads (drift after the tare) become 0. Thread: any (immutable); apply() allocates
/// nothing.
class FrameConditioner {
public:
    /// tare, taxelGain and dead must be empty or have taxels entries; a wrong size is treated as empty.
    FrameConditioner(std::size_t taxels, ConditioningSettings settings);

    /// raw, load_N, dead: taxels entries each. Returns the number of dead taxels.
    std::size_t apply(std::span<const float> raw, std::span<float> load_N,
                      std::span<std::uint8_t> dead) const;

    /// Whether the loads of a frame whose values are finite and >= 0 are these values.
    [[nodiscard]] bool changesNothing() const { return m_isPlain && !m_anyDead; }

    [[nodiscard]] const ConditioningSettings& settings() const { return m_settings; }

private:
    template <bool isPlain>
    std::size_t applyTo(const float* raw, float* load_N, std::uint8_t* dead, std::size_t taxels) const;

    ConditioningSettings m_settings;
    std::vector<float> m_tare;        ///< the tare of the settings, or zeros
    std::vector<double> m_gain;       ///< load per raw unit, with its sign
    std::vector<std::uint8_t> m_dead; ///< the mask of the settings, or zeros
    bool m_isPlain = false;           ///< every tare is 0 and every gain 1: the loads are the raw values
    bool m_anyDead = false;
};

} // namespace teleta::contact
