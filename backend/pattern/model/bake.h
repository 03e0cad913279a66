// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace teleta::pattern {

/// Largest deviation of the straight lines from the curve that they approximate.
inline constexpr double kBakeTolerance = 1e-3;

/// Approximates f(evaluate(pattern, t)[tactor]) over [0, duration] by straight lines within kBakeTolerance. A
/// step is two breakpoints at one time. Silence at the beginning and at the end has no breakpoints. Where no
/// object overlaps them, lines and holds of a track stay exact if f is the identity. f: rising, maps 0..1 to
/// 0..1 and 0 to 0. Error: refused when more than Pattern::kMostBreakpoints would be needed. Thread: any
/// (pure).
[[nodiscard]] core::Expected<Track> linearised(
    const Pattern& pattern, std::size_t tactor,
    const std::function<double(double)>& f = [](double intensity) { return intensity; });

/// The same for all six tactors.
[[nodiscard]] core::Expected<Tracks> linearised(const Pattern& pattern);

/// Converts the objects with these indices into breakpoints of the tracks; where track and object overlap the
/// stronger one counts. Unknown indices are ignored. Tracks that no such object uses are not changed. Error:
/// as linearised().
[[nodiscard]] core::Expected<Pattern> bake(const Pattern& pattern, const std::vector<std::size_t>& objects);

/// Converts all objects into breakpoints.
[[nodiscard]] core::Expected<Pattern> bake(const Pattern& pattern);

/// Removes breakpoints on the straight line between their neighbours, and repeated ones.
[[nodiscard]] Track simplified(const Track& lines);

/// Removes silence at the beginning and at the end, where a tactor is off anyway.
[[nodiscard]] Track trimmed(const Track& lines);

} // namespace teleta::pattern
