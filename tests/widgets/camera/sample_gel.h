// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"

#include <opencv2/core.hpp>

#include <cstdint>

namespace teleta::test {

/// A grey picture of 320 x 240 of 0.1 mm a pixel, with 3 x 3 markers 80 px apart around the middle of the
/// picture. The middle one has moved by 5 px along u, the last one is lost; contact 2 lies around the middle
/// with a slip index of 0.42.
inline pipeline::GelSnapshot sampleGel() {
    pipeline::GelSnapshot snapshot;
    snapshot.image = core::greyImageOf(cv::Mat1b(240, 320, std::uint8_t{90}));
    snapshot.time_ns = 1;
    snapshot.time_s = 1.5;
    snapshot.frame = 40;
    snapshot.scale_m = 1e-4;
    snapshot.noise_m = 3e-6;
    snapshot.corners_m = {Eigen::Vector2d(-5e-5, -5e-5), Eigen::Vector2d(0.03195, -5e-5),
                          Eigen::Vector2d(0.03195, 0.02395), Eigen::Vector2d(-5e-5, 0.02395)};
    snapshot.usable = true;
    snapshot.work_ns = 2'100'000;
    snapshot.processed_Hz = 25.0;
    snapshot.processed = 41;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            vision::GelMarker marker;
            marker.grid = {row, column};
            marker.rest_px = {80.0 + 80.0 * column, 40.0 + 80.0 * row};
            marker.rest_m = 1e-4 * marker.rest_px;
            vision::GelMotion motion;
            motion.found = row != 2 || column != 2;
            motion.place_px = marker.rest_px;
            if (row == 1 && column == 1) {
                motion.place_px.x() += 5.0;
                motion.displacement_m = {5e-4, 0.0};
            }
            snapshot.markers.push_back(marker);
            snapshot.motions.push_back(motion);
        }
    vision::GelContactState contact;
    contact.id = 2;
    contact.markers = {4};
    contact.outline_px = {{120.0, 80.0}, {200.0, 80.0}, {200.0, 160.0}, {120.0, 160.0}};
    contact.outline = {{0.012, 0.008}, {0.020, 0.008}, {0.020, 0.016}, {0.012, 0.016}};
    contact.area_m2 = 64e-6;
    contact.centre_m = {0.016, 0.012};
    contact.normalProxy_m2 = 2e-5;
    contact.shearProxy_m = {0.0, 2e-4};
    contact.torsion_rad = 0.1;
    contact.slipIndex = 0.42;
    snapshot.contacts.push_back(contact);
    return snapshot;
}

} // namespace teleta::test
