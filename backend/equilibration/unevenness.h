// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace teleta::equilibration {

/// How much the taxels of an array differ under one load: the standard deviation of their loads over the
/// mean, s / m with s^2 = sum (x - m)^2 / (n - 1). For an array that is pressed evenly, 0 is best.
struct Unevenness {
    double withGains = 0.0;
    double without = 0.0; ///< of the same frame, each load over the gain of its taxel
};

/// loads: of one frame, each with its gain applied already. gains: one for each load, or empty: all are 1; a
/// taxel without a finite gain above 0 is left out. threshold: in the unit of the loads; only taxels from it
/// on count. Empty for fewer than two of them, for those of a mean that is not above 0, and for gains of
/// another number. Thread: any (pure).
[[nodiscard]] std::optional<Unevenness> unevenness(std::span<const float> loads, std::span<const float> gains,
                                                   double threshold);

} // namespace teleta::equilibration
