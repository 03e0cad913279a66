// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

// What an editor does to single breakpoints and objects, as pure functions: they take a pattern and give
// another one. What concerns whole patterns and stretches of time is in backend/pattern/edit.h.
namespace teleta::editor {

/// One breakpoint of a pattern.
struct PointRef {
    std::size_t track = 0;
    std::size_t index = 0;

    auto operator<=>(const PointRef&) const = default;
};

/// Sorted, without repetition. References that do not exist are ignored by every function.
using PointRefs = std::vector<PointRef>;

/// A pattern after an edit, and where the edited breakpoints are now.
struct Edited {
    pattern::Pattern pattern;
    PointRefs points;
};

/// The breakpoints and objects that were copied, at their own times.
struct PointClip {
    pattern::Tracks tracks;
    std::vector<pattern::PatternObject> objects;

    [[nodiscard]] bool empty() const;
    /// Where its first breakpoint or object begins and its last one ends; zeros when it is empty.
    [[nodiscard]] pattern::Span span() const;
};

/// Puts a breakpoint behind those at the same time; time and intensity are limited to the pattern.
[[nodiscard]] Edited withPoint(const pattern::Pattern& pattern, std::size_t track,
                               pattern::Breakpoint breakpoint);
[[nodiscard]] pattern::Pattern withoutPoints(const pattern::Pattern& pattern, const PointRefs& points);

/// Moves breakpoints together. time_s is limited so that all of them stay in the pattern; each intensity is
/// limited to 0..1. Breakpoints that pass others change places with them.
[[nodiscard]] Edited movedPoints(const pattern::Pattern& pattern, const PointRefs& points, double time_s,
                                 double intensity);
/// One breakpoint as typed, limited to the pattern.
[[nodiscard]] Edited replacedPoint(const pattern::Pattern& pattern, PointRef point,
                                   pattern::Breakpoint breakpoint);
/// Intensities times a factor, limited to 0..1.
[[nodiscard]] pattern::Pattern scaledPoints(const pattern::Pattern& pattern, const PointRefs& points,
                                            double factor);
/// Times from that of the first one on, times a factor > 0; the pattern grows when they need it.
[[nodiscard]] Edited stretchedPoints(const pattern::Pattern& pattern, const PointRefs& points, double factor);
[[nodiscard]] pattern::Pattern easedPoints(const pattern::Pattern& pattern, const PointRefs& points,
                                           pattern::Easing easing);

[[nodiscard]] PointClip copiedPoints(const pattern::Pattern& pattern, const PointRefs& points,
                                     std::optional<std::size_t> object);
/// Puts a clip in, later by so many seconds than it was copied. On each of its tracks it takes the place of
/// what lies between its first and its last breakpoint. The pattern grows when it needs it.
[[nodiscard]] Edited pastedPoints(const pattern::Pattern& pattern, const PointClip& clip, double later_s);

/// An object moved in time; it does not start before 0 and not after the end of the pattern.
[[nodiscard]] pattern::Pattern movedObject(const pattern::Pattern& pattern, std::size_t object,
                                           double time_s);
[[nodiscard]] pattern::Pattern withoutObject(const pattern::Pattern& pattern, std::size_t object);
/// Appends an object; the pattern grows when it needs it.
[[nodiscard]] pattern::Pattern withObject(const pattern::Pattern& pattern, pattern::PatternObject object);

/// Breakpoints of a track in [begin_s, end_s] with an intensity in [low, high].
[[nodiscard]] PointRefs pointsIn(const pattern::Pattern& pattern, std::size_t track, pattern::Span span,
                                 double low, double high);
/// First breakpoint of a track at or after a time.
[[nodiscard]] std::size_t firstFrom(const pattern::Track& track, double time_s);

} // namespace teleta::editor
