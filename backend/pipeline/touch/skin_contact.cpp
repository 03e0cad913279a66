// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <cmath>

namespace teleta::pipeline {

namespace {

/// Parts of one contact on both sides of a seam are no further apart than this.
constexpr double kSeamGate_taxels = 3.0;

} // namespace

void setPlaceErrors(SkinContact& contact, const contact::Contact& patch, const core::ArrayLayout& grid,
                    double threshold_N) {
    if (!(patch.force_N > 0.0))
        return;
    const double rows = patch.maxRow - patch.minRow + 1;
    const double columns = patch.maxColumn - patch.minColumn + 1;
    const double ofTaxel = 0.5 * threshold_N / patch.force_N;
    contact.xSe_m = ofTaxel * grid.pitchX_m * std::sqrt(rows) * 0.5 * (columns + 1.0);
    contact.ySe_m = ofTaxel * grid.pitchY_m * std::sqrt(columns) * 0.5 * (rows + 1.0);
}

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
    if (frame.layout.isGrid()) // elsewhere a patch has no rows and columns
        setPlaceErrors(strongest, first, frame.layout.grid(), frame.threshold_N);
    if (!(circumference_m > 0.0))
        return strongest;
    const double gate_m = kSeamGate_taxels * frame.layout.pitch_m();
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
