// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace teleta::pattern {

/// How far straight lines may be from the curve that they stand for.
inline constexpr double kBakeTolerance = 1e-3;

/// Straight lines within kBakeTolerance of f(evaluate(pattern, t)[tactor]) over [0, duration], with steps as
/// two breakpoints at one time; nothing where the tactor is off for good at begin and end. Lines and holds of
/// a track on which no object lies stay exact when f is the identity. f: 0 at 0, rising, 0..1 to 0..1.
/// Error: refused when that takes more than Pattern::kMostBreakpoints.
[[nodiscard]] core::Expected<Track> linearised(
    const Pattern& pattern, std::size_t tactor,
    const std::function<double(double)>& f = [](double intensity) { return intensity; });

/// All six tactors as straight lines.
[[nodiscard]] core::Expected<Tracks> linearised(const Pattern& pattern);

/// Turns objects (by their numbers, others are ignored) into breakpoints of the tracks, where the stronger of
/// track and object counts. Tracks that they do not touch stay as they are.
[[nodiscard]] core::Expected<Pattern> bake(const Pattern& pattern, const std::vector<std::size_t>& objects);

/// Turns all objects into breakpoints.
[[nodiscard]] core::Expected<Pattern> bake(const Pattern& pattern);

/// Takes out breakpoints on the straight line between their neighbours, and equal ones.
[[nodiscard]] Track simplified(const Track& lines);

/// Takes out stretches of zero at begin and end: the tactor is off there without them.
[[nodiscard]] Track trimmed(const Track& lines);

} // namespace teleta::pattern
