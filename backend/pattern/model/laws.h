// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

namespace teleta::pattern {

/// Apparent motion between neighbouring tactors: SOA = 0.32 d + 47.3 ms.
inline constexpr double kOnsetPerBurst = 0.32;
inline constexpr double kOnsetOffset_s = 0.0473;

/// The direction of a ring is perceived reliably only when a turn takes at least this long.
inline constexpr double kShortestTurn_s = 0.4;

/// Interval between the onsets of bursts on neighbouring tactors at which they are felt as one motion:
///   SOA = 0.32 d + 47.3 ms
/// burst_s: >= 0.
[[nodiscard]] constexpr double apparentMotionOnset_s(double burst_s) {
    return kOnsetPerBurst * burst_s + kOnsetOffset_s;
}

/// Duration of the bursts with which the onsets of a ring fill duration_s exactly:
///   6 n SOA(d) = T,   d = (T / (6 n) - 47.3 ms) / 0.32
/// In 2 s: 3 turns 199.4 ms, 4 turns 112.6 ms, 5 turns 60.5 ms. Empty when there is no such d > 0.
[[nodiscard]] std::optional<double> ringBurst_s(int turns, double duration_s);

/// Intensities of two tactors between which a point is felt, with the energy A1^2 + A2^2 = A^2 preserved:
///   A1 = sqrt(1 - b) A,   A2 = sqrt(b) A
/// balance b: clamped to 0..1; NaN: both are off.
[[nodiscard]] std::pair<double, double> phantomIntensities(double balance, double intensity);

} // namespace teleta::pattern
