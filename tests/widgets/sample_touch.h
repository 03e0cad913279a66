// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/tactile_features.h"
#include "backend/pipeline/touch/touch_snapshot.h"

#include <cmath>
#include <vector>

namespace teleta::test {

/// A load hill: peak at (x, y) of the sensor frame, standard deviations along and across a direction.
struct Hill {
    double x_m = 0.0, y_m = 0.0, peak_N = 1.0;
    double along_m = 0.004, across_m = 0.004, angle_rad = 0.0;
};

/// A snapshot as the pipeline makes it, from loads that are given.
inline pipeline::TouchSnapshot snapshotOf(const core::ArrayLayout& layout, std::vector<float> load_N,
                                          std::vector<std::uint8_t> dead = {}) {
    pipeline::TouchSnapshot snapshot;
    snapshot.layout = layout;
    snapshot.loadUnit = std::string("N");
    snapshot.load_N = std::move(load_N);
    snapshot.dead = dead.empty() ? std::vector<std::uint8_t>(layout.taxels(), 0) : std::move(dead);
    contact::ContactSegmenter segmenter(layout);
    for (contact::Contact contact : segmenter.segment(snapshot.load_N, snapshot.dead)) {
        contact.id = contact.region;
        snapshot.contacts.push_back(contact);
    }
    snapshot.labels.assign(segmenter.labels().begin(), segmenter.labels().end());
    snapshot.features = contact::FeatureExtractor(layout).compute(snapshot.load_N, snapshot.dead);
    snapshot.threshold_N = snapshot.features.threshold_N;
    return snapshot;
}

inline std::vector<float> hills(const core::ArrayLayout& layout, const std::vector<Hill>& list) {
    std::vector<float> load_N(layout.taxels(), 0.0F);
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column)
            for (const Hill& hill : list) {
                const double dx = layout.x_m(column) - hill.x_m, dy = layout.y_m(row) - hill.y_m;
                const double c = std::cos(hill.angle_rad), s = std::sin(hill.angle_rad);
                const double u = (dx * c + dy * s) / hill.along_m, v = (dy * c - dx * s) / hill.across_m;
                load_N[static_cast<std::size_t>(row * layout.columns + column)] +=
                    static_cast<float>(hill.peak_N * std::exp(-0.5 * (u * u + v * v)));
            }
    return load_N;
}

/// A feature sample of a contact that rolls: everything is defined while touched.
inline pipeline::FeatureSample rollingSample(double time_s, bool touched) {
    pipeline::FeatureSample sample;
    sample.time_ns = static_cast<std::int64_t>(std::llround(time_s * 1e9));
    sample.sourceTime_s = time_s;
    contact::TactileFeatures& f = sample.features;
    f.threshold_N = 0.2;
    if (!touched)
        return sample;
    f.type = contact::ContactType::edge;
    f.force_N = 5.0 + 0.8 * std::sin(2.0 * time_s) + 0.15 * std::sin(61.0 * time_s);
    f.copX_m = 0.006 * std::sin(0.7 * time_s);
    f.copY_m = 0.002 * std::cos(0.9 * time_s);
    f.cocX_m = *f.copX_m - 0.0008 * std::sin(1.9 * time_s);
    f.cocY_m = *f.copY_m + 0.0005;
    f.dzmpX_m = *f.copY_m - *f.cocY_m;
    f.dzmpY_m = *f.copX_m - *f.cocX_m;
    f.alphaZ_rad = std::remainder(0.5 * time_s, std::acos(-1.0));
    f.lambda1_m2 = 25e-6;
    f.lambda2_m2 = (3.0 + std::sin(time_s)) * 1e-6;
    f.active = 17 + static_cast<int>(4.0 * std::sin(3.0 * time_s));
    return sample;
}

} // namespace teleta::test
