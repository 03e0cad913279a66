// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::pattern {

/// How the intensity changes from one breakpoint to the next, with u from 0 to 1:
///   linear u;  hold 0;  easeIn 1 - cos(pi u / 2);  easeOut sin(pi u / 2);  easeInOut (1 - cos(pi u)) / 2.
/// Two easeInOut segments up and down are one period of a sine.
enum class Easing { linear, hold, easeIn, easeOut, easeInOut };

/// Unknown keys of a file with their values as JSON text; written back unchanged.
using UnknownKeys = std::vector<std::pair<std::string, std::string>>;

// Parametric objects. Times are in s from the start of the pattern, tactors count from 0, intensities are
// 0..1. All of them are on in half-open intervals of time [start, end).

/// Bursts on one tactor after another. onset_s: from the start of one burst to that of the next; empty: by
/// the law of apparent motion (apparentMotionOnset_s()).
struct Sweep {
    double start_s = 0.0;
    double burst_s = 0.1;
    std::optional<double> onset_s;
    std::vector<int> tactors;
    double intensity = 1.0;

    bool operator==(const Sweep&) const = default;
};

/// Apparent motion around the forearm: 6 * turns bursts whose onsets fill duration_s exactly; the last burst
/// is cut off at the end. burst_s: empty: by the law (ringBurst_s()).
struct Ring {
    double start_s = 0.0;
    double duration_s = 2.0;
    int turns = 3; ///< >= 1
    int firstTactor = 0;
    bool counterClockwise = true; ///< tactors in ascending order
    std::optional<double> burst_s;
    double intensity = 1.0;

    bool operator==(const Ring&) const = default;
};

/// A point felt between two tactors that may move from one to the other: the balance changes linearly from
/// balanceFrom to balanceTo, with 0 at the first tactor and 1 at the second (phantomIntensities()).
struct Phantom {
    double start_s = 0.0;
    double duration_s = 1.0;
    int first = 0;
    int second = 1;
    double balanceFrom = 0.5;
    double balanceTo = 0.5;
    double intensity = 1.0;

    bool operator==(const Phantom&) const = default;
};

/// Changes the intensity of all its tactors from one value to another.
struct Ramp {
    double start_s = 0.0;
    double duration_s = 1.0;
    std::vector<int> tactors;
    double from = 0.0;
    double to = 1.0;
    Easing easing = Easing::linear;

    bool operator==(const Ramp&) const = default;
};

/// Turns all its tactors on for width_s at the start of every period.
struct PulseTrain {
    double start_s = 0.0;
    double duration_s = 1.0;
    double period_s = 0.2;
    double width_s = 0.1;
    std::vector<int> tactors;
    double intensity = 1.0;

    bool operator==(const PulseTrain&) const = default;
};

/// A place on the unrolled forearm at a time. angle_rad: around the arm, not wrapped, so that a stroke can go
/// around several times. along: 0 at the row of the even tactors (0, 120, 240 degrees), 1 at the row of the
/// odd ones, which are shifted along the arm.
struct StrokePoint {
    double time_s = 0.0; ///< from the start of the stroke
    double angle_rad = 0.0;
    double along = 0.0;

    bool operator==(const StrokePoint&) const = default;
};

/// A line drawn on the unrolled forearm, felt as a point that moves along it (strokeIntensities()). points:
/// times never decrease.
struct Stroke {
    double start_s = 0.0;
    std::vector<StrokePoint> points;
    double intensity = 1.0;

    bool operator==(const Stroke&) const = default;
};

using ObjectForm = std::variant<Sweep, Ring, Phantom, Ramp, PulseTrain, Stroke>;

/// A parametric object of a pattern, editable until it is converted into breakpoints (bake()).
struct PatternObject {
    std::string name;
    ObjectForm form;
    UnknownKeys unknown;

    bool operator==(const PatternObject&) const = default;
};

/// An interval of time [begin, end).
struct Span {
    double begin_s = 0.0;
    double end_s = 0.0;
};

/// From the start of the object to where it is off for good.
[[nodiscard]] Span spanOf(const ObjectForm& form);

/// The tactors that an object uses or may use, as the object numbers them.
[[nodiscard]] std::vector<int> listedTactors(const ObjectForm& form);

/// Intensities of one object at a time of the pattern; 0 outside its span. Tactors out of range are taken
/// modulo 6; an object with non-finite values is off. Thread: any (pure).
[[nodiscard]] core::Intensities evaluate(const ObjectForm& form, double t_s);

/// Intensities with which a point is felt at a place of the unrolled forearm. Three tactors in a zigzag form
/// a triangle; with the barycentric weights w_j of the place in its triangle
///   A_j = sqrt(w_j) A
/// which preserves the energy (the sum of A_j^2 is A^2) and equals phantomIntensities() on the line between
/// two neighbours. along: clamped to 0..1. Thread: any (pure).
[[nodiscard]] core::Intensities strokeIntensities(double angle_rad, double along, double intensity);

/// Interval between the onsets of the bursts as they are played; 0 for a ring without turns.
[[nodiscard]] double onsetOf_s(const Sweep& sweep);
[[nodiscard]] double onsetOf_s(const Ring& ring);
/// Duration of a burst as it is played; with more turns than the law allows the bursts follow each other
/// without a gap.
[[nodiscard]] double burstOf_s(const Ring& ring);

} // namespace teleta::pattern
