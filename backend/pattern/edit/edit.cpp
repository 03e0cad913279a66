// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/edit.h"

#include "backend/core/bracelet/tactors.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <cmath>
#include <functional>
#include <type_traits>

namespace teleta::pattern {

namespace {

struct EditText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

int placeInRing(int tactor) {
    return static_cast<int>(core::wrappedTactor(tactor));
}

/// A mapping of the tactors to other places.
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

/// Multiplies all times of an object.
template <typename Form>
void stretch(Form& form, double factor) {
    form.start_s *= factor;
    if constexpr (requires { form.duration_s; })
        form.duration_s *= factor;
    if constexpr (std::is_same_v<Form, Sweep>) {
        form.burst_s *= factor;
        if (form.onset_s)
            *form.onset_s *= factor;
    } else if constexpr (std::is_same_v<Form, Ring>) {
        if (form.burst_s)
            *form.burst_s *= factor;
    } else if constexpr (std::is_same_v<Form, PulseTrain>) {
        form.period_s *= factor;
        form.width_s *= factor;
    } else if constexpr (std::is_same_v<Form, Stroke>) {
        for (StrokePoint& point : form.points)
            point.time_s *= factor;
    }
}

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
        return core::refused(EditText::tr("the pattern cannot be stretched by this factor"),
                             EditText::tr("a factor above 0 that makes it at most a day long"));
    Pattern result = pattern;
    result.duration_s *= factor;
    for (Track& track : result.tracks) {
        for (Breakpoint& point : track)
            point.time_s *= factor;
    }
    for (PatternObject& object : result.objects)
        std::visit([factor](auto& form) { stretch(form, factor); }, object.form);
    return result;
}

} // namespace teleta::pattern
