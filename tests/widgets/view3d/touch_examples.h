// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::test {

/// A round press on an array, in the array's frame.
struct Press {
    int id = 1;
    double x_m = 0.0;
    double y_m = 0.0;
    double peak_N = 1.0;
    double radius_m = 0.006; ///< where the load has fallen to 1/e
};

/// A frame of an array under presses: the load of a taxel is the largest of the presses', a taxel at or over
/// the threshold belongs to the region of the press that loads it most. Contacts hold what was put in.
inline pipeline::TouchSnapshot pressed(const core::ArrayLayout& layout, const std::vector<Press>& presses,
                                       std::uint64_t frame = 1) {
    pipeline::TouchSnapshot snapshot;
    snapshot.layout = layout;
    snapshot.loadUnit = std::string("N");
    snapshot.frame = frame;
    snapshot.framesProcessed = frame;
    snapshot.time_ns = static_cast<std::int64_t>(frame) * 10'000'000;
    snapshot.sourceTime_s = 0.01 * static_cast<double>(frame);
    snapshot.threshold_N = 0.05;
    snapshot.load_N.assign(layout.taxels(), 0.0F);
    snapshot.dead.assign(layout.taxels(), 0);
    snapshot.labels.assign(layout.taxels(), 0);
    for (std::size_t i = 0; i < presses.size(); ++i) {
        contact::Contact contact;
        contact.id = presses[i].id;
        contact.region = static_cast<int>(i) + 1;
        contact.x_m = presses[i].x_m;
        contact.y_m = presses[i].y_m;
        snapshot.contacts.push_back(contact);
    }
    std::size_t taxel = 0;
    for (int row = 0; row < layout.rows; ++row) {
        for (int column = 0; column < layout.columns; ++column, ++taxel) {
            for (std::size_t i = 0; i < presses.size(); ++i) {
                const double dx = layout.x_m(column) - presses[i].x_m;
                const double dy = layout.y_m(row) - presses[i].y_m;
                const double r = presses[i].radius_m;
                const auto load_N =
                    static_cast<float>(presses[i].peak_N * std::exp(-(dx * dx + dy * dy) / (r * r)));
                if (load_N > snapshot.load_N[taxel]) {
                    snapshot.load_N[taxel] = load_N;
                    snapshot.labels[taxel] = static_cast<double>(load_N) >= snapshot.threshold_N
                                                 ? static_cast<std::int32_t>(i) + 1
                                                 : 0;
                }
            }
            if (const auto region = snapshot.labels[taxel]; region > 0) {
                contact::Contact& contact = snapshot.contacts[static_cast<std::size_t>(region) - 1];
                const auto load_N = static_cast<double>(snapshot.load_N[taxel]);
                contact.force_N += load_N;
                contact.peak_N = std::max(contact.peak_N, load_N);
                contact.area_m2 += layout.taxelArea_m2();
                ++contact.taxels;
            }
        }
    }
    std::sort(snapshot.contacts.begin(), snapshot.contacts.end(),
              [](const auto& a, const auto& b) { return a.force_N > b.force_N; });
    return snapshot;
}

} // namespace teleta::test
