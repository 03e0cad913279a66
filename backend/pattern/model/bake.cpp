// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/bake.h"

#include "backend/core/bracelet/tactors.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

struct BakeText {
    Q_DECLARE_TR_FUNCTIONS(BakeText)
};

constexpr double kShortestLine_s = 2e-4;
/// Distance from a corner at which its left and right side are evaluated: the times of corners have rounding
/// errors, at most 1.5e-11 s at the end of the longest pattern.
constexpr double kBeside_s = 1e-9;
constexpr double kStep = 1e-6; ///< values are rounded to it, since they are read beside the corners
constexpr std::size_t kFirstParts = 4;

/// Adds the times at which an object may have a corner on a tactor. Returns false when there are too many.
class Corners {
public:
    Corners(std::vector<double>& times_s, std::size_t tactor)
        : m_times_s(times_s)
        , m_tactor(tactor) {}

    bool operator()(const Sweep& sweep) {
        const double onset_s = onsetOf_s(sweep);
        for (std::size_t k = 0; k < sweep.tactors.size(); ++k) {
            if (core::wrappedTactor(sweep.tactors[k]) == m_tactor)
                add(sweep.start_s + static_cast<double>(k) * onset_s, sweep.burst_s);
        }
        return fits();
    }
    bool operator()(const Ring& ring) {
        const double onset_s = onsetOf_s(ring);
        const double burst_s = burstOf_s(ring);
        if (ring.turns > static_cast<int>(Pattern::kMostBreakpoints))
            return false;
        for (int k = 0; k < static_cast<int>(core::kTactors) * ring.turns && fits(); ++k)
            add(ring.start_s + k * onset_s, burst_s);
        return fits();
    }
    bool operator()(const PulseTrain& train) {
        if (!(train.period_s > 0.0) || !has(train.tactors))
            return true;
        if (!(train.duration_s / train.period_s < static_cast<double>(Pattern::kMostBreakpoints)))
            return false;
        const auto pulses = static_cast<std::size_t>(std::max(0.0, train.duration_s / train.period_s)) + 1;
        for (std::size_t k = 0; k < pulses; ++k)
            add(train.start_s + static_cast<double>(k) * train.period_s, train.width_s);
        return fits();
    }
    bool operator()(const Stroke& stroke) {
        for (const StrokePoint& point : stroke.points)
            m_times_s.push_back(stroke.start_s + point.time_s);
        return fits();
    }
    bool operator()(const Phantom&) { return true; }
    bool operator()(const Ramp&) { return true; }

private:
    void add(double begin_s, double length_s) {
        m_times_s.push_back(begin_s);
        m_times_s.push_back(begin_s + length_s);
    }
    [[nodiscard]] bool has(const std::vector<int>& tactors) const {
        return std::ranges::find(tactors, m_tactor, core::wrappedTactor) != tactors.end();
    }
    [[nodiscard]] bool fits() const { return m_times_s.size() <= Pattern::kMostBreakpoints; }

    std::vector<double>& m_times_s;
    std::size_t m_tactor;
};

core::Unexpected tooMany() {
    return core::refused(BakeText::tr("the pattern has too many corners"),
                         BakeText::tr("at most %1 breakpoints").arg(Pattern::kMostBreakpoints));
}

double rounded(double value) {
    return std::round(value / kStep) * kStep;
}

/// Approximates a function between two corners by straight lines.
class Follower {
public:
    Follower(const std::function<double(double)>& value, Track& lines)
        : m_value(value)
        , m_lines(lines) {}

    /// Adds lines from begin (right side) to end (left side).
    void follow(double begin_s, double end_s) {
        const double beside_s = std::min(kBeside_s, 0.01 * (end_s - begin_s));
        const double first = m_value(begin_s + beside_s);
        const double last = m_value(end_s - beside_s);
        m_lines.push_back({begin_s, rounded(first)});
        double from_s = begin_s;
        double from = first;
        for (std::size_t part = 1; part <= kFirstParts; ++part) {
            const bool isLast = part == kFirstParts;
            const double share = static_cast<double>(part) / kFirstParts;
            const double to_s = isLast ? end_s : begin_s + share * (end_s - begin_s);
            const double to = isLast ? last : m_value(to_s);
            divide(from_s, from, to_s, to);
            from_s = to_s;
            from = to;
        }
    }

private:
    void divide(double begin_s, double first, double end_s, double last) {
        const double middle_s = 0.5 * (begin_s + end_s);
        const double middle = m_value(middle_s);
        bool straight = end_s - begin_s <= kShortestLine_s || m_lines.size() > Pattern::kMostBreakpoints;
        if (!straight) {
            const auto off = [&](double share, double value) {
                return std::abs(first + share * (last - first) - value) > 0.5 * kBakeTolerance;
            };
            straight = !off(0.5, middle) && !off(0.25, m_value(0.75 * begin_s + 0.25 * end_s)) &&
                       !off(0.75, m_value(0.25 * begin_s + 0.75 * end_s));
        }
        if (!straight) {
            divide(begin_s, first, middle_s, middle);
            divide(middle_s, middle, end_s, last);
            return;
        }
        m_lines.push_back({end_s, rounded(last)});
    }

    const std::function<double(double)>& m_value;
    Track& m_lines;
};

bool touches(const ObjectForm& form, double duration_s, std::size_t tactor) {
    const Span span = spanOf(form);
    if (!(span.begin_s < span.end_s && span.begin_s < duration_s && span.end_s > 0.0))
        return false;
    const std::vector<int> tactors = listedTactors(form);
    return std::ranges::find(tactors, tactor, core::wrappedTactor) != tactors.end();
}

/// A track that the end of the pattern cuts off has a corner there, too.
core::Expected<Track> follow(const Pattern& pattern, std::size_t tactor,
                             const std::function<double(double)>& f) {
    std::vector<double> times_s{0.0, pattern.duration_s};
    for (const Breakpoint& point : pattern.tracks[tactor])
        times_s.push_back(point.time_s);
    for (const PatternObject& object : pattern.objects) {
        if (!touches(object.form, pattern.duration_s, tactor))
            continue;
        const Span span = spanOf(object.form);
        times_s.push_back(span.begin_s);
        times_s.push_back(span.end_s);
        if (!std::visit(Corners(times_s, tactor), object.form))
            return tooMany();
    }
    std::erase_if(times_s, [&](double t_s) { return !(t_s >= 0.0 && t_s <= pattern.duration_s); });
    std::ranges::sort(times_s);
    const auto same = [](double a, double b) { return b - a < 4.0 * kBeside_s; };
    times_s.erase(std::unique(times_s.begin(), times_s.end(), same), times_s.end());

    const CompiledPattern compiled(pattern);
    const std::function<double(double)> value = [&](double t_s) { return f(compiled.evaluate(t_s)[tactor]); };
    Track lines;
    Follower follower(value, lines);
    for (std::size_t i = 1; i < times_s.size(); ++i)
        follower.follow(times_s[i - 1], times_s[i]);
    if (lines.size() > Pattern::kMostBreakpoints)
        return tooMany();
    return trimmed(simplified(lines));
}

bool straight(const Track& track) {
    return std::ranges::all_of(track, [](const Breakpoint& point) {
        return point.easing == Easing::linear || point.easing == Easing::hold;
    });
}

/// Replaces holds by two points and limits the values. The caller removes what lies after the end of the
/// pattern.
Track withoutHolds(const Track& track) {
    Track lines;
    for (std::size_t i = 0; i < track.size(); ++i) {
        lines.push_back({track[i].time_s, track[i].intensity});
        if (track[i].easing == Easing::hold && i + 1 < track.size())
            lines.push_back({track[i + 1].time_s, track[i].intensity});
    }
    return lines;
}

} // namespace

Track simplified(const Track& lines) {
    Track kept;
    for (const Breakpoint& point : lines) {
        if (!kept.empty() && kept.back() == point)
            continue;
        while (kept.size() >= 2) {
            const Breakpoint& a = kept[kept.size() - 2];
            const Breakpoint& b = kept.back();
            const double length_s = point.time_s - a.time_s;
            const double share = length_s > 0.0 ? (b.time_s - a.time_s) / length_s : 0.0;
            const double line = a.intensity + share * (point.intensity - a.intensity);
            const bool step = !(length_s > 0.0) || b.time_s == a.time_s || b.time_s == point.time_s;
            const bool middleOfStep = a.time_s == point.time_s; // three points at one time
            if (!middleOfStep && (step || std::abs(line - b.intensity) > kStep))
                break;
            kept.pop_back();
        }
        kept.push_back(point);
    }
    return kept;
}

Track trimmed(const Track& lines) {
    const auto idle = [](const Breakpoint& outer, const Breakpoint& inner) {
        return outer.intensity == 0.0 && (inner.intensity == 0.0 || inner.time_s == outer.time_s);
    };
    std::size_t first = 0;
    while (first + 1 < lines.size() && idle(lines[first], lines[first + 1]))
        ++first;
    std::size_t last = lines.size();
    while (last > first + 1 && idle(lines[last - 1], lines[last - 2]))
        --last;
    if (last - first <= 1)
        return {};
    return {lines.begin() + static_cast<std::ptrdiff_t>(first),
            lines.begin() + static_cast<std::ptrdiff_t>(last)};
}

core::Expected<Track> linearised(const Pattern& pattern, std::size_t tactor,
                                 const std::function<double(double)>& f) {
    const Track& track = pattern.tracks[tactor];
    const bool withObject = std::ranges::any_of(pattern.objects, [&](const PatternObject& object) {
        return touches(object.form, pattern.duration_s, tactor);
    });
    const bool exact = !withObject && straight(track) && f(0.25) == 0.25 && f(0.5) == 0.5 &&
                       (track.empty() || track.back().time_s <= pattern.duration_s);
    if (exact)
        return withoutHolds(track);
    return follow(pattern, tactor, f);
}

core::Expected<Tracks> linearised(const Pattern& pattern) {
    Tracks tracks;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        TELETA_TRY(Track track, linearised(pattern, i));
        tracks[i] = std::move(track);
    }
    return tracks;
}

core::Expected<Pattern> bake(const Pattern& pattern, const std::vector<std::size_t>& objects) {
    Pattern baked = pattern;
    baked.objects.clear();
    Pattern part = pattern;
    part.objects.clear();
    for (std::size_t i = 0; i < pattern.objects.size(); ++i) {
        const bool chosen = std::ranges::find(objects, i) != objects.end();
        (chosen ? part : baked).objects.push_back(pattern.objects[i]);
    }
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const bool touched = std::ranges::any_of(part.objects, [&](const PatternObject& object) {
            return touches(object.form, pattern.duration_s, i);
        });
        if (!touched)
            continue;
        TELETA_TRY(Track track, linearised(part, i));
        baked.tracks[i] = std::move(track);
    }
    return baked;
}

core::Expected<Pattern> bake(const Pattern& pattern) {
    std::vector<std::size_t> all(pattern.objects.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    return bake(pattern, all);
}

} // namespace teleta::pattern
