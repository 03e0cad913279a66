// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/edit.h"

#include "backend/core/bracelet/tactor_ring.h"
#include "backend/pattern/model/easing.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace teleta::pattern {

namespace {

struct EditText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr int kCutParts = 32; ///< lines of an eased segment: at most 0.6e-3 off

int placeInRing(int tactor) {
    return static_cast<int>(core::wrappedTactor(tactor));
}

/// A way to give every tactor another place.
struct Move {
    std::function<int(int)> tactor;
    std::function<double(double)> angle_rad;
    bool swapsRows = false;
    bool turnsRound = false;
};

struct MoveForm {
    const Move& move;

    void all(std::vector<int>& tactors) const {
        for (int& tactor : tactors)
            tactor = move.tactor(tactor);
    }
    void operator()(Sweep& sweep) const { all(sweep.tactors); }
    void operator()(Ramp& ramp) const { all(ramp.tactors); }
    void operator()(PulseTrain& train) const { all(train.tactors); }
    void operator()(Ring& ring) const {
        ring.firstTactor = move.tactor(ring.firstTactor);
        ring.counterClockwise = ring.counterClockwise != move.turnsRound;
    }
    void operator()(Phantom& phantom) const {
        phantom.first = move.tactor(phantom.first);
        phantom.second = move.tactor(phantom.second);
    }
    void operator()(Stroke& stroke) const {
        for (StrokePoint& point : stroke.points) {
            point.angle_rad = move.angle_rad(point.angle_rad);
            if (move.swapsRows)
                point.along = 1.0 - point.along;
        }
    }
};

Pattern moved(const Pattern& pattern, const Move& move) {
    Pattern result = pattern;
    for (int i = 0; i < static_cast<int>(core::kTactors); ++i)
        result.tracks[static_cast<std::size_t>(move.tactor(i))] = pattern.tracks[static_cast<std::size_t>(i)];
    for (PatternObject& object : result.objects)
        std::visit(MoveForm{move}, object.form);
    return result;
}

struct StretchForm {
    double factor;

    void operator()(Sweep& sweep) const {
        sweep.start_s *= factor;
        sweep.burst_s *= factor;
        if (sweep.onset_s)
            *sweep.onset_s *= factor;
    }
    void operator()(Ring& ring) const {
        ring.start_s *= factor;
        ring.duration_s *= factor;
        if (ring.burst_s)
            *ring.burst_s *= factor;
    }
    void operator()(Phantom& phantom) const { both(phantom); }
    void operator()(Ramp& ramp) const { both(ramp); }
    void operator()(PulseTrain& train) const {
        both(train);
        train.period_s *= factor;
        train.width_s *= factor;
    }
    void operator()(Stroke& stroke) const {
        stroke.start_s *= factor;
        for (StrokePoint& point : stroke.points)
            point.time_s *= factor;
    }

private:
    template <typename Form>
    void both(Form& form) const {
        form.start_s *= factor;
        form.duration_s *= factor;
    }
};

/// A point that repeats the last one only tells the easing of the segment that begins there.
void append(Track& track, const Breakpoint& point) {
    if (!track.empty() && track.back().time_s == point.time_s && track.back().intensity == point.intensity)
        track.back() = point;
    else
        track.push_back(point);
}

double valueIn(const Breakpoint& a, const Breakpoint& b, double t_s) {
    return a.intensity +
           eased(a.easing, (t_s - a.time_s) / (b.time_s - a.time_s)) * (b.intensity - a.intensity);
}

/// What a track does in [begin, end), with its own first and last point.
Track slice(const Track& track, double begin_s, double end_s) {
    Track part;
    for (std::size_t k = 1; k < track.size(); ++k) {
        const Breakpoint& a = track[k - 1];
        const Breakpoint& b = track[k];
        const double from_s = std::max(a.time_s, begin_s);
        const double to_s = std::min(b.time_s, end_s);
        if (!(from_s < to_s))
            continue;
        if (from_s == a.time_s && to_s == b.time_s) {
            append(part, a);
            append(part, {b.time_s, b.intensity});
        } else if (a.easing == Easing::hold) {
            append(part, {from_s, a.intensity});
            append(part, {to_s, a.intensity});
        } else {
            const int parts = a.easing == Easing::linear ? 1 : kCutParts;
            for (int i = 0; i <= parts; ++i) {
                const double t_s = i == parts ? to_s : from_s + i * (to_s - from_s) / parts;
                append(part, {t_s, valueIn(a, b, t_s)});
            }
        }
    }
    return part;
}

/// Pieces one after another, silent between them.
Track joined(std::initializer_list<Track> pieces) {
    Track track;
    for (const Track& piece : pieces) {
        if (piece.empty())
            continue;
        if (!track.empty() && track.back().time_s < piece.front().time_s) {
            append(track, {track.back().time_s, 0.0});
            append(track, {piece.front().time_s, 0.0});
        }
        for (const Breakpoint& point : piece)
            append(track, point);
    }
    return track;
}

constexpr double kForever_s = std::numeric_limits<double>::infinity();

} // namespace

Pattern rotated(const Pattern& pattern, int steps) {
    const int turn = placeInRing(steps);
    return moved(pattern, {[turn](int tactor) { return placeInRing(placeInRing(tactor) + turn); },
                           [turn](double angle_rad) { return angle_rad + turn * core::kTactorAngle_rad; },
                           turn % 2 != 0, false});
}

Pattern mirrored(const Pattern& pattern, int axis) {
    const int middle = placeInRing(axis);
    return moved(pattern, {[middle](int tactor) { return placeInRing(middle - placeInRing(tactor)); },
                           [middle](double angle_rad) { return middle * core::kTactorAngle_rad - angle_rad; },
                           middle % 2 != 0, true});
}

Pattern forOtherArm(const Pattern& pattern) {
    Pattern other = mirrored(pattern, 0);
    other.arm = pattern.arm == Arm::left ? Arm::right : Arm::left;
    return other;
}

core::Expected<Pattern> stretched(const Pattern& pattern, double factor) {
    if (!(factor > 0.0) || !std::isfinite(factor) || pattern.duration_s * factor > Pattern::kLongest_s)
        return core::Unexpected(
            core::Error{core::ErrorKind::refused,
                        EditText::tr("the pattern cannot be stretched like that").toStdString(),
                        EditText::tr("a factor above 0 with which it lasts at most a day").toStdString(),
                        {}});
    Pattern result = pattern;
    result.duration_s *= factor;
    for (Track& track : result.tracks) {
        for (Breakpoint& point : track)
            point.time_s *= factor;
    }
    for (PatternObject& object : result.objects)
        std::visit(StretchForm{factor}, object.form);
    return result;
}

Clip copied(const Pattern& pattern, const Span& range, const TactorSet& tactors) {
    Clip clip;
    clip.tactors = tactors;
    if (!(range.begin_s < range.end_s) || !std::isfinite(range.begin_s) || !std::isfinite(range.end_s))
        return clip;
    clip.duration_s = range.end_s - range.begin_s;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (!tactors[i])
            continue;
        clip.tracks[i] = slice(pattern.tracks[i], range.begin_s, range.end_s);
        for (Breakpoint& point : clip.tracks[i])
            point.time_s -= range.begin_s;
    }
    return clip;
}

Pattern erased(const Pattern& pattern, const Span& range, const TactorSet& tactors) {
    Pattern result = pattern;
    if (!(range.begin_s < range.end_s))
        return result;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (tactors[i])
            result.tracks[i] = joined({slice(pattern.tracks[i], -kForever_s, range.begin_s),
                                       slice(pattern.tracks[i], range.end_s, kForever_s)});
    }
    return result;
}

Pattern pasted(const Pattern& pattern, const Clip& clip, double begin_s) {
    Pattern result = pattern;
    const double end_s = begin_s + clip.duration_s;
    if (!(begin_s >= 0.0 && clip.duration_s > 0.0 && end_s <= Pattern::kLongest_s))
        return result;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (!clip.tactors[i])
            continue;
        Track piece = clip.tracks[i];
        for (Breakpoint& point : piece)
            point.time_s = std::min(point.time_s + begin_s, end_s);
        result.tracks[i] = joined({slice(pattern.tracks[i], -kForever_s, begin_s), piece,
                                   slice(pattern.tracks[i], end_s, kForever_s)});
    }
    result.duration_s = std::max(result.duration_s, end_s);
    return result;
}

} // namespace teleta::pattern
