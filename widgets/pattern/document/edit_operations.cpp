// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/document/edit_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::pattern {

namespace {

double share(double value) {
    return value > 0.0 ? std::min(value, 1.0) : 0.0;
}

Breakpoint limited(Breakpoint point, double duration_s) {
    point.time_s = point.time_s > 0.0 ? std::min(point.time_s, duration_s) : 0.0;
    point.intensity = share(point.intensity);
    return point;
}

template <typename Each>
void forEach(const PointRefs& points, const Tracks& tracks, Each each) {
    for (const PointRef& point : points)
        if (point.track < tracks.size() && point.index < tracks[point.track].size())
            each(point);
}

/// First and last time; the first one is later if there are none.
Span timesOf(const PointRefs& points, const Tracks& tracks) {
    constexpr double kNever_s = std::numeric_limits<double>::infinity();
    Span times{kNever_s, -kNever_s};
    forEach(points, tracks, [&](const PointRef& p) {
        const double time_s = tracks[p.track][p.index].time_s;
        times = {std::min(times.begin_s, time_s), std::max(times.end_s, time_s)};
    });
    return times;
}

/// Sorts tracks whose breakpoints have moved and returns the new references of these.
Edited sorted(Pattern pattern, const PointRefs& moved) {
    Edited edited;
    for (std::size_t t = 0; t < core::kTactors; ++t) {
        Track& track = pattern.tracks[t];
        std::vector<std::pair<Breakpoint, bool>> marked;
        marked.reserve(track.size());
        for (const Breakpoint& point : track)
            marked.emplace_back(point, false);
        bool any = false;
        for (const PointRef& point : moved)
            if (point.track == t && point.index < marked.size())
                any = marked[point.index].second = true;
        if (!any)
            continue;
        std::stable_sort(marked.begin(), marked.end(),
                         [](const auto& a, const auto& b) { return a.first.time_s < b.first.time_s; });
        for (std::size_t i = 0; i < marked.size(); ++i) {
            track[i] = marked[i].first;
            if (marked[i].second)
                edited.points.push_back({t, i});
        }
    }
    edited.pattern = std::move(pattern);
    return edited;
}

void shift(ObjectForm& form, double time_s) {
    std::visit([time_s](auto& object) { object.start_s += time_s; }, form);
}

void growTo(Pattern& pattern, double end_s) {
    pattern.duration_s = std::min(std::max(pattern.duration_s, end_s), Pattern::kLongest_s);
}

} // namespace

bool PointClip::empty() const {
    return objects.empty() &&
           std::all_of(tracks.begin(), tracks.end(), [](const Track& t) { return t.empty(); });
}

Span PointClip::span() const {
    if (empty())
        return {};
    Span all{std::numeric_limits<double>::infinity(), 0.0};
    const auto take = [&all](double begin_s, double end_s) {
        all = {std::min(all.begin_s, begin_s), std::max(all.end_s, end_s)};
    };
    for (const Track& track : tracks)
        if (!track.empty())
            take(track.front().time_s, track.back().time_s);
    for (const PatternObject& object : objects) {
        const Span span = spanOf(object.form);
        take(span.begin_s, span.end_s);
    }
    return all;
}

Edited withPoint(const Pattern& pattern, std::size_t track, Breakpoint breakpoint) {
    Edited edited{pattern, {}};
    if (track >= core::kTactors || edited.pattern.tracks[track].size() >= Pattern::kMostBreakpoints)
        return edited;
    breakpoint = limited(breakpoint, pattern.duration_s);
    Track& points = edited.pattern.tracks[track];
    const auto place = std::ranges::upper_bound(points, breakpoint.time_s, {}, &Breakpoint::time_s);
    const auto inserted = points.insert(place, breakpoint);
    edited.points = {{track, static_cast<std::size_t>(inserted - points.begin())}};
    return edited;
}

Pattern withoutPoints(const Pattern& pattern, const PointRefs& points) {
    Pattern result = pattern;
    for (std::size_t t = 0; t < core::kTactors; ++t) {
        std::vector<bool> gone(pattern.tracks[t].size());
        forEach(points, pattern.tracks, [&](const PointRef& p) {
            if (p.track == t)
                gone[p.index] = true;
        });
        Track kept;
        kept.reserve(gone.size());
        for (std::size_t i = 0; i < gone.size(); ++i)
            if (!gone[i])
                kept.push_back(pattern.tracks[t][i]);
        result.tracks[t] = std::move(kept);
    }
    return result;
}

Edited movedPoints(const Pattern& pattern, const PointRefs& points, double time_s, double intensity) {
    const auto [first_s, last_s] = timesOf(points, pattern.tracks);
    if (!(first_s <= last_s) || !std::isfinite(time_s) || !std::isfinite(intensity))
        return {pattern, points};
    const double moved_s = std::max(-first_s, std::min(time_s, std::max(pattern.duration_s - last_s, 0.0)));
    Pattern result = pattern;
    forEach(points, pattern.tracks, [&](const PointRef& p) {
        Breakpoint& point = result.tracks[p.track][p.index];
        point.time_s += moved_s;
        point.intensity = share(point.intensity + intensity);
    });
    return sorted(std::move(result), points);
}

Edited replacedPoint(const Pattern& pattern, PointRef point, Breakpoint breakpoint) {
    Pattern result = pattern;
    forEach({point}, pattern.tracks, [&](const PointRef& p) {
        result.tracks[p.track][p.index] = limited(breakpoint, pattern.duration_s);
    });
    return sorted(std::move(result), {point});
}

Pattern scaledPoints(const Pattern& pattern, const PointRefs& points, double factor) {
    Pattern result = pattern;
    forEach(points, pattern.tracks, [&](const PointRef& p) {
        double& intensity = result.tracks[p.track][p.index].intensity;
        intensity = share(intensity * factor);
    });
    return result;
}

Edited stretchedPoints(const Pattern& pattern, const PointRefs& points, double factor) {
    const auto [first_s, last_s] = timesOf(points, pattern.tracks);
    if (!(factor > 0.0) || !(last_s > first_s))
        return {pattern, points};
    factor = std::min(factor, (Pattern::kLongest_s - first_s) / (last_s - first_s));
    Pattern result = pattern;
    forEach(points, pattern.tracks, [&](const PointRef& p) {
        double& time_s = result.tracks[p.track][p.index].time_s;
        time_s = first_s + (time_s - first_s) * factor;
    });
    growTo(result, first_s + (last_s - first_s) * factor);
    return sorted(std::move(result), points);
}

Pattern easedPoints(const Pattern& pattern, const PointRefs& points, Easing easing) {
    Pattern result = pattern;
    forEach(points, pattern.tracks,
            [&](const PointRef& p) { result.tracks[p.track][p.index].easing = easing; });
    return result;
}

PointClip copiedPoints(const Pattern& pattern, const PointRefs& points, std::optional<std::size_t> object) {
    PointClip clip;
    forEach(points, pattern.tracks,
            [&](const PointRef& p) { clip.tracks[p.track].push_back(pattern.tracks[p.track][p.index]); });
    if (object && *object < pattern.objects.size())
        clip.objects.push_back(pattern.objects[*object]);
    return clip;
}

Edited pastedPoints(const Pattern& pattern, const PointClip& clip, double later_s) {
    if (clip.empty())
        return {pattern, {}};
    const Span span = clip.span();
    later_s = std::max(-span.begin_s, std::min(later_s, Pattern::kLongest_s - span.end_s));
    Edited edited{pattern, {}};
    for (std::size_t t = 0; t < core::kTactors; ++t) {
        Track inserted = clip.tracks[t];
        if (inserted.empty())
            continue;
        for (Breakpoint& point : inserted)
            point.time_s += later_s;
        Track& track = edited.pattern.tracks[t];
        const double end_s = inserted.back().time_s;
        const auto first =
            track.begin() + static_cast<std::ptrdiff_t>(firstFrom(track, inserted.front().time_s));
        const auto last = std::ranges::upper_bound(first, track.end(), end_s, {}, &Breakpoint::time_s);
        const auto at = track.insert(track.erase(first, last), inserted.begin(), inserted.end());
        const auto begin = static_cast<std::size_t>(at - track.begin());
        for (std::size_t i = 0; i < inserted.size(); ++i)
            edited.points.push_back({t, begin + i});
    }
    for (PatternObject object : clip.objects) {
        shift(object.form, later_s);
        edited.pattern.objects.push_back(std::move(object));
    }
    growTo(edited.pattern, span.end_s + later_s);
    return edited;
}

Pattern movedObject(const Pattern& pattern, std::size_t object, double time_s) {
    Pattern result = pattern;
    if (object >= pattern.objects.size() || !std::isfinite(time_s))
        return result;
    const Span span = spanOf(pattern.objects[object].form);
    const double begin_s = std::max(0.0, std::min(span.begin_s + time_s, pattern.duration_s));
    shift(result.objects[object].form, begin_s - span.begin_s);
    return result;
}

Pattern withoutObject(const Pattern& pattern, std::size_t object) {
    Pattern result = pattern;
    if (object < result.objects.size())
        result.objects.erase(result.objects.begin() + static_cast<std::ptrdiff_t>(object));
    return result;
}

Pattern withObject(const Pattern& pattern, PatternObject object) {
    Pattern result = pattern;
    if (result.objects.size() >= Pattern::kMostObjects)
        return result;
    growTo(result, spanOf(object.form).end_s);
    result.objects.push_back(std::move(object));
    return result;
}

PointRefs pointsIn(const Pattern& pattern, std::size_t track, Span span, double low, double high) {
    PointRefs points;
    if (track >= core::kTactors)
        return points;
    const Track& all = pattern.tracks[track];
    for (std::size_t i = firstFrom(all, span.begin_s); i < all.size() && all[i].time_s <= span.end_s; ++i)
        if (all[i].intensity >= low && all[i].intensity <= high)
            points.push_back({track, i});
    return points;
}

std::size_t firstFrom(const Track& track, double time_s) {
    const auto found = std::ranges::lower_bound(track, time_s, {}, &Breakpoint::time_s);
    return static_cast<std::size_t>(found - track.begin());
}

} // namespace teleta::pattern
