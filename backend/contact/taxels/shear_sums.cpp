// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/shear_sums.h"

#include <cmath>
#include <cstddef>

namespace teleta::contact {

namespace {

/// Sums first about the origin of {s}: where the centre of pressure is, is known by then.
void add(const TaxelFrame& frame, std::size_t taxel, ShearLoad& shear) {
    const auto x_N = static_cast<double>(frame.shearX_N[taxel]);
    const auto y_N = static_cast<double>(frame.shearY_N[taxel]);
    shear.x_N += x_N;
    shear.y_N += y_N;
    shear.momentZ_Nm += frame.layout.x_m(taxel) * y_N - frame.layout.y_m(taxel) * x_N;
}

void finish(double force_N, double copX_m, double copY_m, ShearLoad& shear) {
    shear.momentZ_Nm -= copX_m * shear.y_N - copY_m * shear.x_N;
    shear.friction = std::hypot(shear.x_N, shear.y_N) / force_N;
}

} // namespace

void setContactShear(TaxelFrame& frame, std::span<const std::int32_t> labels) {
    if (frame.contacts.empty())
        return;
    for (Contact& contact : frame.contacts)
        contact.shear = ShearLoad{};
    // Regions count from 1 in the order of the contacts.
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] > 0)
            add(frame, i, *frame.contacts[static_cast<std::size_t>(labels[i] - 1)].shear);
    for (Contact& contact : frame.contacts)
        finish(contact.force_N, contact.x_m, contact.y_m, *contact.shear);
}

void setFeatureShear(TaxelFrame& frame, MomentRange range) {
    TactileFeatures& features = frame.features;
    features.shear.reset();
    if (!features.copX_m || !features.copY_m)
        return;
    const auto threshold_N = static_cast<float>(features.threshold_N);
    ShearLoad shear;
    for (std::size_t i = 0; i < frame.load_N.size(); ++i) {
        // What does not press has no shear.
        const bool counts = range == MomentRange::image || frame.load_N[i] >= threshold_N;
        if (frame.dead[i] == 0 && frame.load_N[i] > 0.0F && counts)
            add(frame, i, shear);
    }
    finish(features.force_N, *features.copX_m, *features.copY_m, shear);
    features.shear = shear;
}

} // namespace teleta::contact
