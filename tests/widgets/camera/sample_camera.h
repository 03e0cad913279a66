// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace teleta::test {

/// A grey picture of 820 x 616 with one contact of 60 px around its middle, id 3, at 40 mm along the tube and
/// 90 degrees around it, that has moved by 10 mm along it; an arrow at (100, 100) of (8, 0) pixels.
inline pipeline::CameraSnapshot sampleCamera() {
    pipeline::CameraSnapshot snapshot;
    const int width = 820;
    const int height = 616;
    std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[static_cast<std::size_t>(width * height)]);
    std::memset(pixels.get(), 90, static_cast<std::size_t>(width * height));
    snapshot.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), width, height};
    snapshot.preview = snapshot.image;
    snapshot.time_ns = 1;
    snapshot.time_s = 1.0;
    snapshot.frame = 40;
    snapshot.hasReference = snapshot.usable = true;
    snapshot.rung = "dots";
    snapshot.mayReact = true;
    snapshot.stage_ns = {0, 4'000'000, 500'000, 300'000};
    snapshot.whole_ns = 4'900'000;
    snapshot.processed_Hz = 40.0;
    snapshot.processed = 40;

    vision::FollowedContact followed;
    followed.contact.id = 3;
    followed.contact.centre_px = {410.0, 308.0};
    followed.contact.located = followed.seen = true;
    followed.contact.p_Sensor_Centre_m = {0.0, 0.025, 0.040};
    followed.contact.sd_m = 0.0002;
    followed.contact.depth_m = 0.0011;
    followed.p_Sensor_Start_m = {0.0, 0.025, 0.030};
    for (int i = 0; i < 16; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 16;
        followed.contact.contour_px.emplace_back(static_cast<float>(410.0 + 60.0 * std::cos(turn)),
                                                 static_cast<float>(308.0 + 60.0 * std::sin(turn)));
        const double angle = 0.5 * std::numbers::pi + 0.2 * std::cos(turn);
        followed.contact.contour_m.emplace_back(0.025 * std::cos(angle), 0.025 * std::sin(angle),
                                                0.040 + 0.005 * std::sin(turn));
    }
    snapshot.contacts.push_back(followed);
    // 0.1 mm around the tube, 0.3 mm along it.
    Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
    covariance_m2(0, 0) = 1e-8;
    covariance_m2(2, 2) = 9e-8;
    snapshot.covariances_m2.push_back(covariance_m2);
    snapshot.arrows.push_back({{100.0F, 100.0F}, {8.0F, 0.0F}});
    snapshot.vectors.push_back({{0.025, 0.0, 0.02}, {0.0, 0.0, 0.001}, 0.0001});
    snapshot.vectors.push_back({{-0.025, 0.0, 0.02}, {0.0, 0.0, 0.001}, 0.002}); // nothing but noise
    return snapshot;
}

} // namespace teleta::test
