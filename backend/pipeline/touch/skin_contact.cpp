// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <cmath>

namespace teleta::pipeline {

namespace {

/// Parts of one contact on both sides of a seam are no further apart than this.
constexpr double kSeamGate_taxels = 3.0;

} // namespace

SkinContact strongestContact(const TouchSnapshot& frame, double circumference_m) {
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
