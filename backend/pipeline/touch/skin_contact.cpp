// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace teleta::pipeline {

namespace {

/// Parts of one contact on both sides of a seam are no further apart than this.
constexpr double kSeamGate_taxels = 3.0;

/// y of another contact as seen from the first over the seam, m.
double beyondSeam_m(const contact::Contact& first, const contact::Contact& other, double circumference_m) {
    return other.y_m + std::copysign(circumference_m, first.y_m);
}

bool meetAtSeam(const contact::Contact& first, const contact::Contact& other, double pitch_m,
                double circumference_m) {
    return std::hypot(other.x_m - first.x_m, beyondSeam_m(first, other, circumference_m) - first.y_m) <=
           kSeamGate_taxels * pitch_m;
}

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
    for (std::size_t i = 1; i < frame.contacts.size(); ++i) {
        const contact::Contact& other = frame.contacts[i];
        if (!meetAtSeam(first, other, frame.layout.pitch_m(), circumference_m))
            continue;
        const double y_m = beyondSeam_m(first, other, circumference_m);
        strongest.force_N += other.force_N;
        strongest.x_m += other.force_N / strongest.force_N * (other.x_m - strongest.x_m);
        strongest.y_m += other.force_N / strongest.force_N * (y_m - strongest.y_m);
    }
    return strongest;
}

void joinAtSeam(TouchSnapshot& frame, double circumference_m) {
    if (!(circumference_m > 0.0))
        return;
    std::vector<contact::Contact>& contacts = frame.contacts;
    bool joined = false;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        for (std::size_t k = i + 1; k < contacts.size(); ++k) {
            if (contacts[i].id <= 0 || contacts[k].id <= 0 ||
                !meetAtSeam(contacts[i], contacts[k], frame.layout.pitch_m(), circumference_m))
                continue;
            const auto [id, other] = std::minmax({contacts[i].id, contacts[k].id});
            for (contact::Contact& part : contacts)
                if (part.id == other)
                    part.id = id;
            joined = true;
        }
    if (!joined)
        return;
    const contact::Contact& first = contacts.front();
    double force_N = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    bool single = true;
    for (const contact::Contact& part : contacts) {
        single = single && part.id == first.id;
        const double own_m = std::signbit(part.y_m) == std::signbit(first.y_m)
                                 ? part.y_m
                                 : beyondSeam_m(first, part, circumference_m);
        force_N += part.force_N;
        x_m += part.force_N * part.x_m;
        y_m += part.force_N * own_m;
    }
    contact::TactileFeatures& features = frame.features;
    for (auto* left : {&features.copX_m, &features.copY_m, &features.cocX_m, &features.cocY_m,
                       &features.dzmpX_m, &features.dzmpY_m, &features.alphaZ_rad})
        left->reset();
    if (single && force_N > 0.0) {
        features.copX_m = x_m / force_N;
        features.copY_m = std::remainder(y_m / force_N, circumference_m);
    }
}

} // namespace teleta::pipeline
