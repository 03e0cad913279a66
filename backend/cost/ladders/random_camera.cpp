// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/random_camera.h"

#include "backend/vision/camera/nominal_camera.h"

#include <Eigen/Geometry>

#include <numbers>

namespace teleta::cost {

vision::CameraParameters randomCamera(core::RandomStream& random) {
    const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    vision::CameraParameters camera = vision::nominalCamera(1640, 1232).camera().parameters();
    camera.fx_px *= between(0.9, 1.1);
    camera.fy_px = camera.fx_px * between(0.98, 1.02);
    camera.cx_px += between(-40.0, 40.0);
    camera.cy_px += between(-40.0, 40.0);
    const vision::RationalDistortion nominal = camera.distortion;
    // As far as the surface of the tube is off the axis: 65 degrees.
    constexpr double kFarthest = 2.2;
    do {
        camera.distortion = nominal;
        camera.distortion.k1 *= between(0.95, 1.05);
        camera.distortion.k4 *= between(0.95, 1.05);
        camera.distortion.p1 = between(-1e-3, 1e-3);
        camera.distortion.p2 = between(-1e-3, 1e-3);
    } while (vision::monotoneRadius(camera.distortion, kFarthest) < kFarthest);
    camera.R_Camera_Sensor =
        (Eigen::AngleAxisd(between(-0.05, 0.05), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(between(-0.05, 0.05), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(between(-std::numbers::pi, std::numbers::pi), Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    camera.p_Sensor_Camera_m = {between(-0.002, 0.002), between(-0.002, 0.002), between(-0.023, -0.017)};
    camera.mirrored = random.uniform() < 0.5;
    return camera;
}

} // namespace teleta::cost
