// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <string>

namespace teleta::pattern {

/// HJIF, the JSON form of ISO/IEC 23090-31 (MPEG haptics): one perception on the right forearm, a channel a
/// tactor whose direction is the place on the ring, vectorial waves of which the amplitude is the intensity.
/// Times become whole milliseconds; of a step the first point moves a millisecond ahead. date: "2026-01-31".
/// Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date);

/// Channels belong to the tactor nearest to their direction, or without directions to that of their order.
/// Basis effects with keyframes are read; amplitudes times the channel's gain are intensities; frequencies
/// follow from them and are left out. Error: badInput with the place, also for what a pattern cannot hold
/// (other effects, more than six channels, libraries).
[[nodiscard]] core::Expected<Pattern> patternFromHjif(std::string text, const std::string& file);

} // namespace teleta::pattern
