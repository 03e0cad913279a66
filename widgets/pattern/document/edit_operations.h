// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

// Edits of breakpoints and objects as pure functions; those of whole patterns are in backend/pattern/edit.
namespace teleta::pattern {

/// One breakpoint of a pattern.
struct PointRef {
    std::size_t track = 0;
    std::size_t index = 0;

    auto operator<=>(const PointRef&) const = default;
};

/// Sorted, without duplicates. Every function ignores references that do not exist.
using PointRefs = std::vector<PointRef>;

/// A pattern after an edit, and the new references of the edited breakpoints.
struct Edited {
    Pattern pattern;
    PointRefs points;
};

/// Copied breakpoints and objects at their original times.
struct PointClip {
    Tracks tracks;
    std::vector<PatternObject> objects;

    [[nodiscard]] bool empty() const;
    /// From the begin of its first breakpoint or object to the end of its last one; zeros when empty.
    [[nodiscard]] Span span() const;
};

/// Inserts a breakpoint after those at the same time. Time and intensity are clamped to the pattern.
[[nodiscard]] Edited withPoint(const Pattern& pattern, std::size_t track, Breakpoint breakpoint);
[[nodiscard]] Pattern withoutPoints(const Pattern& pattern, const PointRefs& points);

/// Moves breakpoints together. time_s is limited so that all of them stay in the pattern; each intensity is
/// clamped to 0..1. Breakpoints that pass others are reordered.
[[nodiscard]] Edited movedPoints(const Pattern& pattern, const PointRefs& points, double time_s,
                                 double intensity);
/// Replaces a breakpoint by typed values, clamped to the pattern.
[[nodiscard]] Edited replacedPoint(const Pattern& pattern, PointRef point, Breakpoint breakpoint);
/// Multiplies intensities by a factor and clamps them to 0..1.
[[nodiscard]] Pattern scaledPoints(const Pattern& pattern, const PointRefs& points, double factor);
/// Multiplies the times relative to the first breakpoint by a factor > 0; extends the pattern if needed.
[[nodiscard]] Edited stretchedPoints(const Pattern& pattern, const PointRefs& points, double factor);
[[nodiscard]] Pattern easedPoints(const Pattern& pattern, const PointRefs& points, Easing easing);

[[nodiscard]] PointClip copiedPoints(const Pattern& pattern, const PointRefs& points,
                                     std::optional<std::size_t> object);
/// Inserts a clip later_s after its original time. On each of its tracks it replaces what lies between its
/// first and its last breakpoint. Extends the pattern if needed.
[[nodiscard]] Edited pastedPoints(const Pattern& pattern, const PointClip& clip, double later_s);

/// Moves an object in time; its start stays within the pattern.
[[nodiscard]] Pattern movedObject(const Pattern& pattern, std::size_t object, double time_s);
[[nodiscard]] Pattern withoutObject(const Pattern& pattern, std::size_t object);
/// Appends an object; extends the pattern if needed.
[[nodiscard]] Pattern withObject(const Pattern& pattern, PatternObject object);

/// Breakpoints of a track in [begin_s, end_s] with an intensity in [low, high].
[[nodiscard]] PointRefs pointsIn(const Pattern& pattern, std::size_t track, Span span, double low,
                                 double high);
/// Index of the first breakpoint of a track at or after a time.
[[nodiscard]] std::size_t firstFrom(const Track& track, double time_s);

} // namespace teleta::pattern
