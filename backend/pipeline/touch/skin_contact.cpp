// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <cmath>

namespace teleta::pipeline {

namespace {

/// Parts of one contact on both sides of a seam are no further apart than this.
constexpr double kSeamGate_taxels = 3.0;

} // namespace

double taxelNoise_N(double threshold_N) {
    return threshold_N / 3.0;
}

void setPlaceErrors(SkinContact& contact, const contact::Contact& patch, double pitch_m, double noise_N,
                    double systematic_m) {
    const double known_m = systematic_m > 0.0 ? systematic_m : kCentroidSe_pitches * pitch_m;
    const double relativeNoise = patch.force_N > 0.0 ? noise_N / patch.force_N : 0.0;
    const auto errorAlong_m = [&](int from, int to) {
        const double width_m = (to - from + 1) * pitch_m;
        return std::hypot(known_m, relativeNoise * std::sqrt(patch.taxels / 12.0) * width_m);
    };
    contact.xSe_m = errorAlong_m(patch.minColumn, patch.maxColumn);
    contact.ySe_m = errorAlong_m(patch.minRow, patch.maxRow);
}

SkinContact strongestContact(const TouchSnapshot& frame, double circumference_m, double systematic_m) {
    SkinContact strongest;
    strongest.time_ns = frame.time_ns;
    strongest.sourceTime_s = frame.sourceTime_s;
    if (frame.contacts.empty())
        return strongest;
    const contact::Contact& first = frame.contacts.front(); // in order of falling force
    strongest.touching = true;
    strongest.x_m = first.x_m;
    strongest.y_m = first.y_m;
    strongest.force_N = first.force_N;
    strongest.type = frame.features.type;
    setPlaceErrors(strongest, first, frame.layout.pitch_m, taxelNoise_N(frame.threshold_N), systematic_m);
    if (!(circumference_m > 0.0))
        return strongest;
    const double gate_m = kSeamGate_taxels * frame.layout.pitch_m;
    for (std::size_t i = 1; i < frame.contacts.size(); ++i) {
        const contact::Contact& other = frame.contacts[i];
        const double y_m = other.y_m + std::copysign(circumference_m, first.y_m);
        if (std::hypot(other.x_m - first.x_m, y_m - first.y_m) > gate_m)
            continue;
        strongest.force_N += other.force_N;
        strongest.x_m += other.force_N / strongest.force_N * (other.x_m - strongest.x_m);
        strongest.y_m += other.force_N / strongest.force_N * (y_m - strongest.y_m);
    }
    return strongest;
}

} // namespace teleta::pipeline
