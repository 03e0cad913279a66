// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladder_camera.h"

#include "backend/vision/camera/nominal_camera.h"

#include <Eigen/Geometry>

#include <cmath>
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

Eigen::Vector3d tubePoint_m(double angle_rad, double z_m) {
    constexpr double kTubeRadius_m = 0.025;
    return {kTubeRadius_m * std::cos(angle_rad), kTubeRadius_m * std::sin(angle_rad), z_m};
}

Eigen::Vector3d middleOfTube_m() {
    return {0.0, 0.0, 0.05};
}

Eigen::Vector3d exactDirection(const vision::CameraParameters& camera, const Eigen::Vector3d& p_Sensor_m) {
    Eigen::Vector3d direction = p_Sensor_m - camera.p_Sensor_Camera_m;
    if (camera.mirrored)
        direction.y() = -direction.y();
    return camera.R_Camera_Sensor * direction;
}

Eigen::Vector2d exactPixel(const vision::CameraParameters& camera, const Eigen::Vector3d& p_Sensor_m) {
    const Eigen::Matrix<long double, 3, 1> d = exactDirection(camera, p_Sensor_m).cast<long double>();
    const long double x = d.x() / d.z();
    const long double y = d.y() / d.z();
    const long double s = x * x + y * y;
    const vision::RationalDistortion& lens = camera.distortion;
    const long double k1 = lens.k1, k2 = lens.k2, k3 = lens.k3, k4 = lens.k4, k5 = lens.k5, k6 = lens.k6;
    const long double p1 = lens.p1, p2 = lens.p2;
    const long double q =
        (1.0L + k1 * s + k2 * s * s + k3 * s * s * s) / (1.0L + k4 * s + k5 * s * s + k6 * s * s * s);
    const long double u = q * x + 2.0L * p1 * x * y + p2 * (s + 2.0L * x * x);
    const long double v = q * y + p1 * (s + 2.0L * y * y) + 2.0L * p2 * x * y;
    return {static_cast<double>(camera.fx_px * u + camera.skew_px * v + camera.cx_px),
            static_cast<double>(camera.fy_px * v + camera.cy_px)};
}

} // namespace teleta::cost
